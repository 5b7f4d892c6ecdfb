//--- vertex
//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
// SPDX-License-Identifier: BSD-3-Clause

in vec4 vertexMC;



// frag position in VC
out vec4 vertexVCVSOutput;

// optional normal declaration
//VTK::Normal::Dec
in vec3 normalMC;
uniform mat3 normalMatrix;
out vec3 normalVCVSOutput;

// extra lighting parameters
//VTK::Light::Dec

// Texture coordinates
//VTK::TCoord::Dec

// material property values
//VTK::Color::Dec

// clipping plane vars
//VTK::Clip::Dec

// camera and actor matrix values
uniform mat4 MCDCMatrix;
uniform mat4 MCVCMatrix;

// Apple Bug
//VTK::PrimID::Dec

// Value raster
//VTK::ValuePass::Dec

// picking support
//VTK::Picking::Dec

// Surface with edges on GLES 3.0
//VTK::EdgesGLES30::Dec

// PointSize on GLES 3.0
//VTK::PointSizeGLES30::Dec

// LineWidth on GLES 3.0
//VTK::LineWidthGLES30::Dec

void main()
{
  //VTK::PointSizeGLES30::Impl

  //VTK::CustomBegin::Impl

  //VTK::Color::Impl

  normalVCVSOutput = normalMatrix * normalMC;
//VTK::Normal::Impl

  //VTK::TCoord::Impl

  //VTK::Clip::Impl

  //VTK::PrimID::Impl

  vertexVCVSOutput = MCVCMatrix * vertexMC;
  gl_Position = MCDCMatrix * vertexMC;


  //VTK::LineWidthGLES30::Impl

  //VTK::ValuePass::Impl

  //VTK::Light::Impl

  //VTK::Picking::Impl

  //VTK::CustomEnd::Impl

  //VTK::EdgesGLES30::Impl
}

//--- geometry
//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
// SPDX-License-Identifier: BSD-3-Clause
// Template for the polydata mappers geometry shader

uniform int PrimitiveIDOffset;

// VC position of this fragment
in vec4 vertexVCVSOutput[];
out vec4 vertexVCGSOutput;

// primitiveID
//VTK::PrimID::Dec

// optional color passed in from the vertex shader, vertexColor
//VTK::Color::Dec

// optional surface normal declaration
//VTK::Normal::Dec
in vec3 normalVCVSOutput[];
out vec3 normalVCGSOutput;

// extra lighting parameters
//VTK::Light::Dec

// Texture coordinates
//VTK::TCoord::Dec

// picking support
//VTK::Picking::Dec

// Depth Peeling Support
//VTK::DepthPeeling::Dec

// clipping plane vars
//VTK::Clip::Dec

// the output of this shader
//VTK::Output::Dec

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

uniform vec4 vpDims;
out vec4 edgeEqn[3];
uniform float lineWidth;

uniform samplerBuffer edgeTexture;

void main()
{
  //VTK::Normal::Start

  vec2 pos[4];

  for (int i = 0; i < 3; i++)
  {
    pos[i] = gl_in[i].gl_Position.xy/gl_in[i].gl_Position.w;
    pos[i] = pos[i]*vec2(0.5) + vec2(0.5);
    pos[i] = pos[i]*vpDims.zw + vpDims.xy;
  }
  pos[3] = pos[0];

  float ccw = sign(cross(vec3(pos[1] - pos[0], 0.0), vec3(pos[2] - pos[0], 0.0)).z);

  for (int i = 0; i < 3; i++)
  {
    vec2 tmp = normalize(pos[i+1] - pos[i]);
    tmp = ccw*vec2(-tmp.y, tmp.x);
    float d = dot(pos[i], tmp);
    edgeEqn[i] = vec4(tmp.x, tmp.y, 0.0, -d);
  }

  vec2 offsets[3];

  offsets[0] = edgeEqn[2].xy + edgeEqn[0].xy;
  offsets[0] = -0.5*normalize(offsets[0])*lineWidth;
  offsets[0] /= vpDims.zw;

  offsets[1] = edgeEqn[0].xy + edgeEqn[1].xy;
  offsets[1] = -0.5*normalize(offsets[1])*lineWidth;
  offsets[1] /= vpDims.zw;

  offsets[2] = edgeEqn[1].xy + edgeEqn[2].xy;
  offsets[2] = -0.5*normalize(offsets[2])*lineWidth;
  offsets[2] /= vpDims.zw;

  float edgeValues = 255.0*texelFetch(edgeTexture, gl_PrimitiveIDIn + PrimitiveIDOffset).r;
if (edgeValues < 4.0) edgeEqn[2].z = lineWidth;
if (mod(edgeValues, 4.0) < 2.0) edgeEqn[1].z = lineWidth;
if (mod(edgeValues, 2.0) < 1.0) edgeEqn[0].z = lineWidth;


  for (int i = 0; i < 3; i++)
    {
    gl_PrimitiveID = gl_PrimitiveIDIn;

    //VTK::Clip::Impl

    //VTK::Color::Impl

    //VTK::Normal::Impl
normalVCGSOutput = normalVCVSOutput[i];

    //VTK::Light::Impl

    //VTK::TCoord::Impl

    //VTK::DepthPeeling::Impl

    //VTK::Picking::Impl

    // VC position of this fragment
    vertexVCGSOutput = vertexVCVSOutput[i];

    // gl_Position = gl_in[i].gl_Position;

    gl_Position = gl_in[i].gl_Position;
    gl_Position.xy = gl_Position.xy + offsets[i]*gl_Position.w;

    EmitVertex();
    }
  EndPrimitive();
}

//--- fragment
//VTK::System::Dec

// SPDX-FileCopyrightText: Copyright (c) Ken Martin, Will Schroeder, Bill Lorensen
// SPDX-License-Identifier: BSD-3-Clause
// Template for the polydata mappers fragment shader

uniform int PrimitiveIDOffset;



// VC position of this fragment
in vec4 vertexVCVSOutput;

// Camera prop
uniform int cameraParallel;


// optional color passed in from the vertex shader, vertexColor
uniform float ambientIntensity; // the material ambient
uniform float diffuseIntensity; // the material diffuse
uniform float opacityUniform; // the fragment opacity
uniform vec3 ambientColorUniform; // ambient color
uniform vec3 diffuseColorUniform; // diffuse color
uniform float specularIntensity; // the material specular intensity
uniform vec3 specularColorUniform; // intensity weighted color
uniform float specularPowerUniform;


// optional surface normal declaration
//VTK::Normal::Dec
uniform mat3 normalMatrix;
in vec3 normalVCVSOutput;

// extra lighting parameters
#define CLEAR_COAT
//VTK::Define::Dec
uniform vec3 lightColor0;
uniform vec3 lightDirectionVC0; // normalized
uniform vec3 lightPositionVC0;
uniform vec3 lightAttenuation0;
uniform float lightConeAngle0;
uniform float lightExponent0;
uniform int lightPositional0;uniform vec3 lightColor1;
uniform vec3 lightDirectionVC1; // normalized
uniform vec3 lightPositionVC1;
uniform vec3 lightAttenuation1;
uniform float lightConeAngle1;
uniform float lightExponent1;
uniform int lightPositional1;
const float PI = 3.14159265359;
const float recPI = 0.31830988618;
uniform float metallicUniform;
uniform float roughnessUniform;
uniform vec3 emissiveFactorUniform;
uniform float aoStrengthUniform;
uniform float baseF0Uniform;
uniform vec3 edgeTintUniform;
#ifdef ANISOTROPY
uniform float anisotropyUniform;
#endif
#ifdef CLEAR_COAT
uniform float coatF0Uniform;
uniform float coatStrengthUniform;
uniform float coatRoughnessUniform;
uniform vec3 coatColorUniform;
#endif
float D_GGX(float NdH, float roughness)
{
  float a = roughness * roughness;
  float a2 = a * a;
  float d = (NdH * a2 - NdH) * NdH + 1.0;
  return a2 / (PI * d * d);
}
float V_SmithCorrelated(float NdV, float NdL, float roughness)
{
  float a2 = roughness * roughness;
  float ggxV = NdL * sqrt(a2 + NdV * (NdV - a2 * NdV));
  float ggxL = NdV * sqrt(a2 + NdL * (NdL - a2 * NdL));
  return 0.5 / (ggxV + ggxL);
}
vec3 F_Schlick(vec3 F0, vec3 F90, float HdL)
{
  return F0 + (F90 - F0) * pow(1.0 - HdL, 5.0);
}
vec3 DiffuseLambert(vec3 albedo)
{
  return albedo * recPI;
}
vec3 SpecularIsotropic(float NdH, float NdV, float NdL, float HdL, float roughness,
  vec3 F0, vec3 F90, out vec3 F)
{
  float D = D_GGX(NdH, roughness);
  float V = V_SmithCorrelated(NdV, NdL, roughness);
  F = F_Schlick(F0, F90, HdL);
  return (D * V) * F;
}
#ifdef ANISOTROPY
// Anisotropy functions
float D_GGX_Anisotropic(float at, float ab, float TdH, float BdH, float NdH)
{
  float a2 = at * ab;
  vec3 d = vec3(ab * TdH, at * BdH, a2 * NdH);
  float d2 = dot(d, d);
  float b2 = a2 / d2;
  return a2 * b2 * b2 * recPI;
}
float V_SmithGGXCorrelated_Anisotropic(float at, float ab, float TdV, float BdV,
  float TdL, float BdL, float NdV, float NdL)
{
  float lambdaV = NdL * length(vec3(at * TdV, ab * BdV, NdV));
  float lambdaL = NdV * length(vec3(at * TdL, ab * BdL, NdL));
  return 0.5 / (lambdaV + lambdaL);
}
vec3 SpecularAnisotropic(float at, float ab, vec3 l, vec3 t, vec3 b, vec3 h, float TdV,
  float BdV, float NdH, float NdV, float NdL, float HdL, float roughness, float anisotropy,
  vec3 F0, vec3 F90, out vec3 F)
{
  float TdL = dot(t, l);
  float BdL = dot(b, l);
  float TdH = dot(t, h);
  float BdH = dot(b, h);
  // specular anisotropic BRDF
  float D = D_GGX_Anisotropic(at, ab, TdH, BdH, NdH);
  float V = V_SmithGGXCorrelated_Anisotropic(at, ab, TdV, BdV, TdL, BdL, NdV, NdL);
  F = F_Schlick(F0, F90, HdL);
  return (D * V) * F;
}
#endif


// Texture maps
//VTK::TMap::Dec

// Texture coordinates
//VTK::TCoord::Dec

// picking support
//VTK::Picking::Dec

// Depth Peeling Support
//VTK::DepthPeeling::Dec

// clipping plane vars
//VTK::Clip::Dec

// the output of this shader
//VTK::Output::Dec

// Apple Bug
//VTK::PrimID::Dec

// handle coincident offsets
//VTK::Coincident::Dec

// Value raster
//VTK::ValuePass::Dec

// surface with edges
in vec4 edgeEqn[3];
uniform float lineWidth;
uniform vec3 edgeColor;
uniform float edgeOpacity;


void main()
{
  // VC position of this fragment. This should not branch/return/discard.
  vec4 vertexVC = vertexVCVSOutput;

  // Place any calls that require uniform flow (e.g. dFdx) here.
  //VTK::UniformFlow::Impl

  // Set gl_FragDepth here (gl_FragCoord.z by default)
  //VTK::Depth::Impl

  // Early depth peeling abort:
  //VTK::DepthPeeling::PreColor

  // Apple Bug
  //VTK::PrimID::Impl

  //VTK::Clip::Impl

  //VTK::ValuePass::Impl

    vec3 specularColor = specularIntensity * specularColorUniform;
  float specularPower = specularPowerUniform;
  vec3 ambientColor = ambientIntensity * ambientColorUniform;
  vec3 diffuseColor = diffuseIntensity * diffuseColorUniform;
  float opacity = opacityUniform;


  float edist[3];
edist[0] = dot(edgeEqn[0].xy, gl_FragCoord.xy) + edgeEqn[0].w;
edist[1] = dot(edgeEqn[1].xy, gl_FragCoord.xy) + edgeEqn[1].w;
edist[2] = dot(edgeEqn[2].xy, gl_FragCoord.xy) + edgeEqn[2].w;
if (edist[0] < -0.5 && edgeEqn[0].z > 0.0) discard;
if (edist[1] < -0.5 && edgeEqn[1].z > 0.0) discard;
if (edist[2] < -0.5 && edgeEqn[2].z > 0.0) discard;
edist[0] += edgeEqn[0].z;
edist[1] += edgeEqn[1].z;
edist[2] += edgeEqn[2].z;
float emix = clamp(0.5 + 0.5*lineWidth - min( min( edist[0], edist[1]), edist[2]), 0.0, 1.0);
  diffuseColor = mix(diffuseColor, vec3(0.0), emix * edgeOpacity);
  ambientColor = mix( ambientColor, edgeColor, emix * edgeOpacity);


  // Generate the normal if we are not passed in one
  vec3 normalVCVSOutput = normalize(normalVCVSOutput);
  if (gl_FrontFacing == false) { normalVCVSOutput = -normalVCVSOutput; }
vec3 coatNormalVCVSOutput = normalVCVSOutput;
//VTK::Normal::Impl

  vec3 albedo = diffuseColor;
  float roughness = roughnessUniform;
  float metallic = metallicUniform;
  float ao = 1.0;
  vec3 emissiveColor = vec3(0.0);
  vec3 N = normalVCVSOutput;
  vec3 V = normalize(-vertexVC.xyz);
  float NdV = clamp(dot(N, V), 1e-5, 1.0);
  vec3 coatN = coatNormalVCVSOutput;
  float coatRoughness = coatRoughnessUniform;
  float coatStrength = coatStrengthUniform;
  float coatNdV = clamp(dot(coatN, V), 1e-5, 1.0);
  vec3 irradiance = vec3(0.0);
  vec3 prefilteredSpecularColor = vec3(0.0);
  vec2 brdf = vec2(0.0, 0.0);
  vec3 prefilteredSpecularCoatColor = vec3(0.0);
  vec2 coatBrdf = vec2(0.0);
  vec3 Lo = vec3(0.0);
  vec3 F0 = mix(vec3(baseF0Uniform), albedo, metallic);
  float f90 = clamp(dot(F0, vec3(50.0 * 0.33)), 0.0, 1.0);
  vec3 F90 = mix(vec3(f90), edgeTintUniform, metallic);
  vec3 L, H, radiance, F, specular, diffuse;
  float NdL, NdH, HdL, distanceVC, attenuation, D, Vis;

  vec3 coatF0 = vec3(coatF0Uniform);
  vec3 coatF90 = vec3(1.0);
  vec3 coatLayer, Fc;
  float coatNdL, coatNdH;
  vec3 coatColorFactor = mix(vec3(1.0), coatColorUniform, coatStrength);
  L = lightPositionVC0 - vertexVC.xyz;
  distanceVC = length(L);
  L = normalize(L);
  H = normalize(V + L);
  NdL = clamp(dot(N, L), 1e-5, 1.0);
  NdH = clamp(dot(N, H), 1e-5, 1.0);
  HdL = clamp(dot(H, L), 1e-5, 1.0);
  if (lightPositional0 == 0)
  {
    attenuation = 1.0;
  }
  else
  {
    attenuation = 1.0 / (lightAttenuation0.x
      + lightAttenuation0.y * distanceVC
      + lightAttenuation0.z * distanceVC * distanceVC);
    // cone angle is less than 90 for a spot light
    if (lightConeAngle0 < 90.0) {
      float coneDot = dot(-L, lightDirectionVC0);
      // if inside the cone
      if (coneDot >= cos(radians(lightConeAngle0)))
      {
        attenuation = attenuation * pow(coneDot, lightExponent0);
      }
      else
      {
        attenuation = 0.0;
      }
    }
  }
  radiance = lightColor0 * attenuation;
  specular = SpecularIsotropic(NdH, NdV, NdL, HdL, roughness, F0, F90, F);
  diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);
  coatNdL = clamp(dot(coatN, L), 1e-5, 1.0);
  coatNdH = clamp(dot(coatN, H), 1e-5, 1.0);
  // Clear coat is isotropic
  coatLayer = SpecularIsotropic(coatNdH, coatNdV, coatNdL, HdL, coatRoughness, coatF0, coatF90, Fc) * radiance * coatNdL * coatStrength;
  // Energy compensation depending on how much light is reflected by the coat layer
  Fc *= coatStrength;
  specular *= (1.0 - Fc) * (1.0 - Fc);
  diffuse *= (1.0 - Fc);
  radiance *= coatColorFactor;
  Lo += coatLayer;
  Lo += radiance * (diffuse + specular) * NdL;
  L = lightPositionVC1 - vertexVC.xyz;
  distanceVC = length(L);
  L = normalize(L);
  H = normalize(V + L);
  NdL = clamp(dot(N, L), 1e-5, 1.0);
  NdH = clamp(dot(N, H), 1e-5, 1.0);
  HdL = clamp(dot(H, L), 1e-5, 1.0);
  if (lightPositional1 == 0)
  {
    attenuation = 1.0;
  }
  else
  {
    attenuation = 1.0 / (lightAttenuation1.x
      + lightAttenuation1.y * distanceVC
      + lightAttenuation1.z * distanceVC * distanceVC);
    // cone angle is less than 90 for a spot light
    if (lightConeAngle1 < 90.0) {
      float coneDot = dot(-L, lightDirectionVC1);
      // if inside the cone
      if (coneDot >= cos(radians(lightConeAngle1)))
      {
        attenuation = attenuation * pow(coneDot, lightExponent1);
      }
      else
      {
        attenuation = 0.0;
      }
    }
  }
  radiance = lightColor1 * attenuation;
  specular = SpecularIsotropic(NdH, NdV, NdL, HdL, roughness, F0, F90, F);
  diffuse = (1.0 - metallic) * (1.0 - F) * DiffuseLambert(albedo);
  coatNdL = clamp(dot(coatN, L), 1e-5, 1.0);
  coatNdH = clamp(dot(coatN, H), 1e-5, 1.0);
  // Clear coat is isotropic
  coatLayer = SpecularIsotropic(coatNdH, coatNdV, coatNdL, HdL, coatRoughness, coatF0, coatF90, Fc) * radiance * coatNdL * coatStrength;
  // Energy compensation depending on how much light is reflected by the coat layer
  Fc *= coatStrength;
  specular *= (1.0 - Fc) * (1.0 - Fc);
  diffuse *= (1.0 - Fc);
  radiance *= coatColorFactor;
  Lo += coatLayer;
  Lo += radiance * (diffuse + specular) * NdL;
  // In IBL, we assume that v=n, so the amount of light reflected is
  // the reflectance F0
  vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;
  vec3 iblSpecular = prefilteredSpecularColor * specularBrdf;
  vec3 iblDiffuse = (1.0 - F0) * (1.0 - metallic) * irradiance * albedo;
  vec3 color = iblDiffuse + iblSpecular;

  // Clear coat attenuation
  Fc = F_Schlick(coatF0, coatF90, coatNdV) * coatStrength;
  iblSpecular *= (1.0 - Fc);
  iblDiffuse *= (1.0 - Fc) * (1.0 - Fc);
  // Clear coat specular
  vec3 iblSpecularClearCoat = prefilteredSpecularCoatColor * (coatF0 * coatBrdf.r + coatBrdf.g) * Fc;
  color *= coatColorFactor;
  color += iblSpecularClearCoat;

  color += Lo;
  color = mix(color, color * ao, aoStrengthUniform);
  color += emissiveColor;
  color = pow(color, vec3(1.0/2.2));
  gl_FragData[0] = vec4(color, opacity);
  //VTK::Light::Impl



  

  if (gl_FragData[0].a <= 0.0)
    {
    discard;
    }

  //VTK::DepthPeeling::Impl

  //VTK::Picking::Impl

  // handle coincident offsets
  //VTK::Coincident::Impl
}

