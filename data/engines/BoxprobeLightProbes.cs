// Boxprobe's diffuse light as light probes in Unity (2021 and later). Written from Unity's documentation, not run. Made with:
//     boxprobe export SCENE -o scene.glb --format glb
//     python3 boxprobe_diffuse.py scene.glb -o Assets/Probes --for unity
// Put this file into a folder named Editor; then choose Assets > Import Boxprobe Light Probes and light-probes.json, bake the lighting, which
// makes Unity's probes in those places, and choose Assets > Fill Boxprobe Light Probes: each takes the coefficients of the nearest place.
//
// Positions and coefficients have x negated already, as glTFast and UnityGLTF import glTF files.
using System;
using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Rendering;

public static class BoxprobeLightProbes
{
    [Serializable] class Probes { public string format; public float[] positions, coefficients; }

    static Probes Read(out Vector3[] places)
    {
        places = null;
        string path = EditorUtility.OpenFilePanel("light-probes.json", "Assets", "json");
        if (string.IsNullOrEmpty(path)) return null;
        Probes probes = JsonUtility.FromJson<Probes>(File.ReadAllText(path));
        if (probes.format != "boxprobe-light-probes") throw new Exception(path + ": not written by boxprobe_diffuse.py --for unity");
        places = new Vector3[probes.positions.Length / 3];
        for (int i = 0; i < places.Length; i++)
            places[i] = new Vector3(probes.positions[3 * i], probes.positions[3 * i + 1], probes.positions[3 * i + 2]);
        return probes;
    }

    [MenuItem("Assets/Import Boxprobe Light Probes")]
    static void Import()
    {
        if (Read(out Vector3[] places) == null) return;
        var made = new GameObject("Boxprobe light probes");
        made.AddComponent<LightProbeGroup>().probePositions = places;
        Undo.RegisterCreatedObjectUndo(made, "Import Boxprobe light probes");
    }

    [MenuItem("Assets/Fill Boxprobe Light Probes")]
    static void Fill()
    {
        Probes probes = Read(out Vector3[] places);
        if (probes == null) return;
        LightProbes baked = LightmapSettings.lightProbes;
        if (baked == null || baked.count == 0) throw new Exception("bake the lighting first: there are no light probes");
        SphericalHarmonicsL2[] values = baked.bakedProbes;
        for (int i = 0; i < values.Length; i++)
        {
            int nearest = 0;
            for (int k = 1; k < places.Length; k++)
                if ((places[k] - baked.positions[i]).sqrMagnitude < (places[nearest] - baked.positions[i]).sqrMagnitude) nearest = k;
            for (int channel = 0; channel < 3; channel++)
                for (int k = 0; k < 9; k++) values[i][channel, k] = probes.coefficients[27 * nearest + 9 * channel + k];
        }
        baked.bakedProbes = values;
        EditorUtility.SetDirty(baked);
    }
}
