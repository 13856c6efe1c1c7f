/**
 * A shadow on the ground with a wide, even edge: twelve points of the map on Vogel's spiral, turned a little from pixel to
 * pixel. Three's own shadow takes five, which leaves dots in an edge this wide.
 */
import { ShaderMaterial, UniformsLib, UniformsUtils } from 'three';

/** Width of the edge (texels of the map). */
const RADIUS = '15.0';
const POINTS = 12;

const vertexShader = /* glsl */ `
  #include <common>
  #include <shadowmap_pars_vertex>
  void main() {
    #include <beginnormal_vertex>
    #include <defaultnormal_vertex>
    #include <begin_vertex>
    #include <project_vertex>
    #include <worldpos_vertex>
    #include <shadowmap_vertex>
  }
`;

const fragmentShader = /* glsl */ `
  uniform float opacity;
  #include <common>
  #include <lights_pars_begin>
  #include <shadowmap_pars_fragment>
  void main() {
    float lit = 1.0;
    #if NUM_DIR_LIGHT_SHADOWS > 0 && defined( SHADOWMAP_TYPE_PCF )
      vec3 place = vDirectionalShadowCoord[ 0 ].xyz / vDirectionalShadowCoord[ 0 ].w;
      vec2 reach = ${RADIUS} / directionalLightShadows[ 0 ].shadowMapSize;
      place.z += directionalLightShadows[ 0 ].shadowBias;
      if ( all( greaterThan( place, vec3( 0.0 ) ) ) && all( lessThan( place, vec3( 1.0 ) ) ) ) {
        float turn = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
        lit = 0.0;
        for ( int i = 0; i < ${POINTS}; i ++ ) {
          lit += texture( directionalShadowMap[ 0 ], vec3( place.xy + vogelDiskSample( i, ${POINTS}, turn ) * reach, place.z ) );
        }
        lit /= ${POINTS}.0;
      }
    #endif
    gl_FragColor = vec4( vec3( 0.0 ), opacity * ( 1.0 - lit ) );
  }
`;

/** Black where the key light does not reach, `opacity` (0 to 1, a uniform) at the darkest. Writes no depth. */
export function softShadow(): ShaderMaterial {
  return new ShaderMaterial({
    uniforms: { ...UniformsUtils.clone(UniformsLib.lights), opacity: { value: 0 } },
    vertexShader,
    fragmentShader,
    lights: true,
    transparent: true,
    depthWrite: false,
    toneMapped: false,
  });
}
