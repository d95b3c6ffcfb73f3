#include "render/shaders.h"

#include <cstdio>

#include "render/light.h"

namespace halsted::render {

std::string shaderHead() {
  char head[160];
  const Vec3 l = lightDirection();
  std::snprintf(head, sizeof head, "#version 330 core\nconst vec3 kLamp = vec3(%.6f, %.6f, %.6f);\n", l.x(), l.y(), l.z());
  return head;
}

std::string fragmentHead() {
  return shaderHead() + R"(
// What polished metal mirrors of the theatre, from its sphere map: lamps are far brighter than walls, the square keeps them so.
vec3 mirrored(sampler2D theatre, vec3 n, vec3 v) {
  vec3 r = reflect(-v, n) + vec3(0.0, 0.0, 1.0);
  vec3 seen = texture(theatre, 0.5 + 0.5 * r.xy * inversesqrt(dot(r, r))).rgb;
  return seen * seen;
}
// The normal of a surface with a relief of that height [m], of which `share` counts. From screen derivatives (Mikkelsen 2010): no
// tangents to follow what moves.
vec3 bumped(vec3 n, vec3 position, float height, float share) {
  vec3 px = dFdx(position), py = dFdy(position);
  vec3 rx = cross(py, n), ry = cross(n, px);
  float det = dot(px, rx);
  vec3 slope = sign(det) * (dFdx(height) * rx + dFdy(height) * ry);
  return normalize(abs(det) * n - share * slope);
}
// Light that goes on round the edge of what scatters it, by colour.
vec3 wrapped(float towards, vec3 wrap) { return clamp((towards + wrap) / (1.0 + wrap), 0.0, 1.0); }
// A shadow leaves 0.56 of the square root, 0.31 of the light.
float shadowed(sampler2DShadow lamp, vec3 at) { return 0.56 + 0.44 * texture(lamp, at); }
// How much a wire covers of a pixel: it fades over its last half pixel.
float wireCover(float facing, float pixels) { return clamp((1.0 - sqrt(1.0 - facing * facing)) * pixels, 0.0, 1.0); }
)";
}

const char* const kRigidVertex = R"(
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec2 aUv;
layout(location = 3) in vec4 aColor;
uniform mat4 uModel, uViewProjection, uShadowMatrix;
invariant gl_Position;                    // the field is drawn twice and must meet itself
out vec3 vPosition, vNormal, vShadow;
out vec2 vUv;
out vec4 vColor;
void main() {
  vec4 world = uModel * vec4(aPosition, 1.0);
  vPosition = world.xyz;
  vNormal = mat3(uModel) * aNormal;
  vShadow = (uShadowMatrix * world).xyz;
  vUv = aUv;
  vColor = aColor;
  gl_Position = uViewProjection * world;
})";

// An operating lamp is wide: the core of a shadow narrows with the distance of what casts it. An instrument thins toward the hand.
const char* const kInstrumentDepthVertex = R"(
layout(location = 0) in vec3 aPosition;
uniform mat4 uModel, uViewProjection;
void main() {
  float core = clamp(1.15 - aPosition.z / 0.085, 0.0, 1.0);
  gl_Position = uViewProjection * uModel * vec4(aPosition.xy * core, min(aPosition.z, 0.1), 1.0);
})";

const char* const kTissueVertex = R"(
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec2 aUv;
layout(location = 3) in vec4 aColor;      // reflectance, sky reaching it
layout(location = 4) in vec4 aSurface;    // vessels, bumps, gloss, 1 in the lumen
layout(location = 5) in float aCharred;   // 0 where tissue cannot be cut
layout(location = 6) in float aBruised;   // 1 where it is injured
uniform mat4 uViewProjection, uShadowMatrix;
uniform float uOpen;                      // 1 at rest, 0 when the lumen is shut
out vec3 vPosition, vNormal, vShadow;
out vec2 vUv;
out vec4 vColor;
out vec3 vSurface;
out float vCharred, vBruised;
void main() {
  vPosition = aPosition;
  vNormal = aNormal;
  vShadow = (uShadowMatrix * vec4(aPosition, 1.0)).xyz;
  vUv = aUv;
  vColor = vec4(aColor.rgb * aColor.rgb, aColor.a * mix(1.0, 0.35 + 0.65 * uOpen, aSurface.a));
  vSurface = aSurface.rgb;
  vCharred = aCharred;
  vBruised = aBruised;
  gl_Position = uViewProjection * vec4(aPosition, 1.0);
})";

const char* const kTubeVertex = R"(
layout(location = 0) in vec3 aCentre;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec3 aTube;       // radius, along, turn
uniform mat4 uModel, uViewProjection, uShadowMatrix;
uniform vec3 uEye;
uniform float uPixelSize;                 // [1] size of a pixel at distance 1; 0 in the shadow map
out vec3 vPosition, vNormal, vShadow;
out vec2 vUv;
out float vPixels;
void main() {
  vec3 centre = (uModel * vec4(aCentre, 1.0)).xyz;
  vNormal = mat3(uModel) * aNormal;
  float pixel = uPixelSize * distance(uEye, centre);
  float radius = aTube.x > 0.0 ? max(aTube.x, 0.75 * pixel) + 0.5 * pixel : 0.0;   // half a pixel more, which the edge fades over; none across a cut
  vPixels = radius / max(pixel, 1e-9);
  vPosition = centre + vNormal * radius;
  vShadow = (uShadowMatrix * vec4(vPosition, 1.0)).xyz;
  vUv = aTube.yz;
  gl_Position = uViewProjection * vec4(vPosition, 1.0);
})";

const char* const kHoleVertex = R"(
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec2 aCorner;
uniform mat4 uViewProjection;
out vec2 vCorner;
void main() {
  vCorner = aCorner;
  gl_Position = uViewProjection * vec4(aPosition, 1.0);
})";

const char* const kDepthFragment = "void main() {}";

// Multiplies what the backdrop shows.
const char* const kFieldFragment = R"(
in vec3 vShadow;
uniform sampler2DShadow uShadow;
out vec4 color;
void main() { color = vec4(vec3(shadowed(uShadow, vShadow)), 1.0); }
)";

const char* const kFieldBareFragment = R"(
in vec2 vUv;
uniform sampler2D uSurface;
out vec4 color;
void main() { color = vec4(texture(uSurface, vUv).rgb, 1.0); }
)";

const char* const kSteelFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in vec4 vColor;
uniform sampler2D uReflection;
uniform sampler2DShadow uShadow;
uniform vec3 uEye;
out vec4 color;
void main() {
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  // Brushed across the shaft, which blurs reflections along it. Two waves that never meet: a texture would cost five times that.
  float streak = 0.35 * (abs(fract(vUv.y * 741.0) - 0.5) + abs(fract(vUv.y * 1313.0 + 2.0 * vUv.x) - 0.5) - 0.5);
  n = normalize(n + streak * vec3(0.035, 0.05, 0.035));
  vec3 seen = mirrored(uReflection, n, v);
  float lit = texture(uShadow, vShadow);
  float edge = 1.0 - clamp(dot(n, v), 0.0, 1.0);
  vec3 steel = vColor.rgb * vColor.rgb;
  steel += (1.0 - steel) * edge * edge * edge * 0.6;
  vec3 c = steel * (4.0 * seen * (0.5 + 0.5 * lit) + 0.10 * lit * max(dot(n, kLamp), 0.0) + 0.03) * (1.0 + 0.25 * streak);
  color = vec4(sqrt(c), 1.0);
})";

const char* const kNeedleFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in float vPixels;
uniform sampler2D uReflection;
uniform sampler2DShadow uShadow;
uniform vec3 uEye;
out vec4 color;
void main() {
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 seen = mirrored(uReflection, n, v);
  float lit = texture(uShadow, vShadow);
  vec3 c = vec3(0.86, 0.88, 0.90) * (4.0 * seen * (0.5 + 0.5 * lit) + 0.08);
  color = vec4(sqrt(c), wireCover(facing, vPixels));
})";

const char* const kThreadFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in float vPixels;
uniform sampler2DShadow uShadow;
uniform vec3 uEye, uTint;
out vec4 color;
void main() {
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  float turns = 6.2831853 * vUv.y, along = 6.2831853 * vUv.x;
  float ply = 0.5 + 0.5 * sin(turns + along * 520.0);                     // one dark ply in a lay of 1.9 mm: shows the twist
  float braid = sin(3.0 * turns + along * 1500.0) * sin(3.0 * turns - along * 1500.0);
  float near = clamp(vPixels * 0.2 - 0.6, 0.0, 1.0);                       // the braid only where it can be resolved
  float lit = texture(uShadow, vShadow + vec3(0.0, 0.0, -0.0015));
  ply = mix(0.62, ply, clamp(vPixels * 0.55 - 0.6, 0.25, 1.0));
  vec3 base = uTint * (0.40 + 0.95 * ply) * (1.0 + 0.5 * near * braid);
  float diffuse = clamp(dot(n, kLamp) * 0.7 + 0.3, 0.0, 1.0);
  vec3 h = normalize(v + kLamp);
  float s = clamp(dot(n, h), 0.0, 1.0); s *= s; s *= s; s *= s; s *= s;
  vec3 c = base * (0.30 + 1.15 * diffuse * (0.25 + 0.75 * lit)) + 0.28 * lit * s * (0.5 + 0.5 * ply);
  color = vec4(sqrt(c), wireCover(facing, vPixels));
})";

const char* const kTissueFragment = R"(
in vec3 vPosition, vNormal, vShadow;
in vec2 vUv;
in vec4 vColor;
in vec3 vSurface;
in float vCharred, vBruised;
uniform sampler2D uSurface, uReflection;
uniform sampler2DShadow uShadow;
uniform vec3 uEye;
out vec4 color;
void main() {
  vec4 detail = texture(uSurface, vUv);
  vec3 n = normalize(vNormal), v = normalize(uEye - vPosition);
  float height = detail.b * vSurface.g * 0.0011;
  float filled = texture(uSurface, vUv, 0.7).b * vSurface.g * 0.0011;
  vec3 film = bumped(n, vPosition, filled, 0.55);           // fluid fills the finest dents, which would glitter: broad, wet lights
  n = bumped(n, vPosition, height, 1.0);

  float lit = texture(uShadow, vShadow);
  vec3 albedo = vColor.rgb * (0.80 + 0.40 * detail.r);
  albedo = mix(albedo, vec3(0.34, 0.022, 0.030), detail.g * vSurface.r);
  float hurt = vBruised * (0.6 + 0.8 * detail.r);                      // blood in the wall: red where it was pressed too hard, livid where it is injured
  albedo = mix(albedo, vec3(0.40, 0.030, 0.040), 0.75 * smoothstep(0.0, 0.2, hurt));
  albedo = mix(albedo, vec3(0.13, 0.014, 0.045), 0.85 * smoothstep(0.5, 1.2, hurt));
  float burnt = clamp(vCharred * (0.75 + 0.5 * detail.b), 0.0, 1.0);   // blanched, then brown, then black and dry
  albedo = mix(albedo, vec3(0.50, 0.33, 0.22), smoothstep(0.03, 0.25, burnt));
  albedo = mix(albedo, vec3(0.13, 0.055, 0.028), smoothstep(0.25, 0.55, burnt));
  albedo = mix(albedo, vec3(0.022, 0.017, 0.015), smoothstep(0.55, 0.95, burnt));
  float sky = vColor.a;
  vec3 wrap = vec3(0.42, 0.22, 0.18);                       // red light scatters furthest in the wall
  vec3 direct = wrapped(dot(n, kLamp), wrap) * mix(vec3(0.20, 0.07, 0.06), vec3(1.0), lit);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 ambient = mix(vec3(0.17, 0.13, 0.13), vec3(0.34, 0.34, 0.36), 0.5 + 0.5 * n.z);
  ambient += 0.24 * facing * facing;                        // the surgeon's headlight: it throws no shadow that the eye could see
  vec3 c = albedo * (direct * (0.15 + 0.85 * sky) * 1.12 + ambient * sky);

  float grazing = 1.0 - facing; grazing *= grazing; grazing *= grazing;
  float gloss = vSurface.b * (0.45 + 0.75 * detail.a) * (1.0 - 0.88 * smoothstep(0.1, 0.6, burnt));
  float s = clamp(dot(film, normalize(v + kLamp)), 0.0, 1.0);
  s *= s; s *= s; s *= s; float broad = s * s;              // power 16
  s = broad * broad; s *= s; s *= s;                        // power 128
  float back = clamp(dot(film, v), 0.0, 1.0);
  back *= back; back *= back; back *= back; back *= back; back *= back; back *= back;   // power 64: the headlight's glints
  vec3 seen = mirrored(uReflection, film, v);
  c += gloss * ((1.9 * s + 0.13 * broad) * lit + 0.55 * back * sky + ((0.10 + 0.45 * grazing) * seen + 2.2 * seen * seen) * sky * (0.35 + 0.65 * lit));
  vec3 glare = max(c - 0.7, 0.0);                           // rolls off toward white as film does
  color = vec4(sqrt(min(c, 0.7) + glare / (1.0 + glare / 0.3)), 1.0);
})";

const char* const kHoleFragment = R"(
in vec2 vCorner;
out vec4 color;
void main() {
  float d = length(vCorner);
  color = vec4(mix(vec3(0.10, 0.0, 0.0), vec3(0.42, 0.05, 0.05), smoothstep(0.4, 0.9, d)), 0.92 * (1.0 - smoothstep(0.65, 1.0, d)));
})";

const char* const kSmokeVertex = R"(
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec2 aCorner;
layout(location = 2) in float aStrength;
uniform mat4 uViewProjection;
out vec2 vCorner;
out float vStrength;
void main() {
  vCorner = aCorner;
  vStrength = aStrength;
  gl_Position = uViewProjection * vec4(aPosition, 1.0);
})";

const char* const kSmokeFragment = R"(
in vec2 vCorner;
in float vStrength;
out vec4 color;
void main() {
  float inside = max(0.0, 1.0 - dot(vCorner, vCorner));
  color = vec4(0.80, 0.81, 0.84, vStrength * inside * inside);
})";

}  // namespace halsted::render
