// Boxprobe's probes in Bevy 0.19 (features "ktx2" and "serde"). Written from Bevy's sources, not run. Exported with:
//     boxprobe export SCENE -o assets/probes --format ktx2 --ladder bevy --center
//
//     spawn_boxprobe(&mut commands, &asset_server, "probes", include_str!("../assets/probes/room.json"));
//
// Bevy's lookups start in the middle of the box: --center moves the cubemap there.
use bevy::light::{EnvironmentMapLight, LightProbe, ParallaxCorrection};
use bevy::prelude::*;

fn vector(json: &serde_json::Value) -> Vec3 {
    let component = |i: usize| json[i].as_f64().unwrap_or(0.0) as f32;
    Vec3::new(component(0), component(1), component(2))
}

/// `folder` below assets/ holds the files that the text `json` names.
pub fn spawn_boxprobe(commands: &mut Commands, assets: &AssetServer, folder: &str, json: &str) -> serde_json::Result<Entity> {
    let probe: serde_json::Value = serde_json::from_str(json)?;
    let file = |key: &str| format!("{folder}/{}", probe[key].as_str().unwrap_or_default());
    let q = &probe["rotationQuaternion"];
    let component = |i: usize| q[i].as_f64().unwrap_or(0.0) as f32;
    let half = 0.5 * vector(&probe["box"]["size"]);
    let influence = vector(&probe["influence"]["size"]);
    let blend = 0.5 * (vector(&probe["blendDistance"]["min"]) + vector(&probe["blendDistance"]["max"]));
    // The same scale along all axes: Bevy samples with a direction of the scaled probe, which another scale would bend. So the
    // influence is the cube around the influence box.
    let scale = influence.max_element();
    let parallax = if probe["projection"].as_bool().unwrap_or(true) {
        ParallaxCorrection::Custom(half / scale)
    } else {
        ParallaxCorrection::None
    };
    Ok(commands
        .spawn((
            LightProbe { falloff: blend / scale },
            EnvironmentMapLight {
                specular_map: assets.load(file("file")),
                diffuse_map: assets.load(file("diffuseFile")),
                intensity: probe["intensity"].as_f64().unwrap_or(1.0) as f32,
                ..default()
            },
            parallax,
            Transform::from_translation(vector(&probe["box"]["center"]))
                .with_rotation(Quat::from_xyzw(component(0), component(1), component(2), component(3)))
                .with_scale(Vec3::splat(scale)),
        ))
        .id())
}
