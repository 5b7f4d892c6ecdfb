// Is a fragment between the eye and the cut box, in front of where the box is entered? Inserted before main().
uniform mat4 bpCutFromView;  // the box becomes the cube from -1 to 1
uniform int bpCut;           // 0: nothing is cut, 1: perspective, 2: parallel projection

bool bpIsCut(vec3 positionView)
{
  if (bpCut == 0) return false;
  vec3 eyeView = bpCut == 2 ? vec3(positionView.xy, 0.0) : vec3(0.0);
  vec3 eye = (bpCutFromView * vec4(eyeView, 1.0)).xyz;
  vec3 along = (bpCutFromView * vec4(positionView, 1.0)).xyz - eye;
  // A ray along a face would divide by zero.
  along = mix(along, vec3(1.0e-9), vec3(lessThan(abs(along), vec3(1.0e-9))));
  vec3 low = (vec3(-1.0) - eye) / along;
  vec3 high = (vec3(1.0) - eye) / along;
  vec3 near = min(low, high);
  vec3 far = max(low, high);
  float enters = max(max(near.x, near.y), near.z);
  float leaves = min(min(far.x, far.y), far.z);
  return enters >= 1.0 && enters <= leaves;  // the fragment is at 1
}

// First in main().
#define BP_CUT if (bpIsCut(vertexVCVSOutput.xyz)) discard;
