// Boxprobe's probes in Unity (2021 and later, built-in and universal pipelines). Written from Unity's documentation, not run.
// Exported with: boxprobe export SCENE -o Assets/Probes --format dds --ladder unity
// Put this file into a folder named Editor; then choose Assets > Import Boxprobe Probes and the folder.
//
// Positions and cubes have x negated, as glTFast and UnityGLTF import glTF files. Unity's boxes are not turned.
using System;
using System.IO;
using UnityEditor;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

public static class BoxprobeImport
{
    [Serializable] class Bounds3 { public float[] min, max, center, size; }
    [Serializable] class Blend { public float[] min, max; }
    [Serializable] class Ladder { public string name; public int faceSize; }
    [Serializable] class Probe
    {
        public string format, name, file;
        public float[] origin;
        public Bounds3 box, influence;
        public Blend blendDistance;
        public float importance, intensity;
        public bool projection;
        public Ladder ladder;
    }

    [MenuItem("Assets/Import Boxprobe Probes")]
    static void Import()
    {
        string folder = EditorUtility.OpenFolderPanel("Folder of exported probes", "Assets", "");
        if (string.IsNullOrEmpty(folder)) return;
        foreach (string path in Directory.GetFiles(folder, "*.json"))
        {
            Probe probe = JsonUtility.FromJson<Probe>(File.ReadAllText(path));
            if (probe.format != "boxprobe-export") continue;
            if (probe.ladder.name != "unity") throw new Exception(path + ": export it with --format dds --ladder unity");
            string asset = FileUtil.GetProjectRelativePath(Path.ChangeExtension(path, ".asset"));
            Cubemap cubemap = ReadCube(Path.Combine(folder, probe.file));
            AssetDatabase.CreateAsset(cubemap, asset);
            Place(probe, cubemap);
        }
        AssetDatabase.SaveAssets();
    }

    /// DDS with the DX10 header, 148 bytes: half floats, each face followed by its levels.
    static Cubemap ReadCube(string path)
    {
        const int header = 148;
        byte[] bytes = File.ReadAllBytes(path);
        int size = BitConverter.ToInt32(bytes, 12), levels = BitConverter.ToInt32(bytes, 28);
        var cubemap = new Cubemap(size, GraphicsFormat.R16G16B16A16_SFloat, TextureCreationFlags.MipChain, levels);
        int offset = header;
        for (int face = 0; face < 6; face++)
        {
            for (int level = 0; level < levels; level++)
            {
                int side = Mathf.Max(size >> level, 1);
                cubemap.SetPixelData(bytes, level, (CubemapFace)face, offset);
                offset += side * side * 8;
            }
        }
        cubemap.Apply(false);
        return cubemap;
    }

    static Vector3 Mirrored(float[] v) { return new Vector3(-v[0], v[1], v[2]); }

    static void Place(Probe probe, Cubemap cubemap)
    {
        var reflection = new GameObject(probe.name).AddComponent<ReflectionProbe>();
        reflection.transform.position = Mirrored(probe.origin);
        reflection.mode = ReflectionProbeMode.Custom;
        reflection.customBakedTexture = cubemap;
        reflection.boxProjection = probe.projection;
        // One box serves as projection and influence, relative to the origin.
        reflection.center = Mirrored(probe.box.center) - Mirrored(probe.origin);
        reflection.size = new Vector3(probe.box.size[0], probe.box.size[1], probe.box.size[2]);
        reflection.blendDistance = Mathf.Max(probe.blendDistance.min);
        reflection.importance = Mathf.RoundToInt(probe.importance);
        reflection.intensity = probe.intensity;
        Undo.RegisterCreatedObjectUndo(reflection.gameObject, "Import Boxprobe probe");
    }
}
