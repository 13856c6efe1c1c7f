/**
 * What a surface mirrors of the studio, in a few lines of its own shader: a ceiling that is bright above the subject, a
 * strip of light low behind it, the floor. It stands in where no environment is made, and brings the weak fill light in
 * both cases, for less than a light of its own would cost.
 */
import type { MeshStandardMaterial } from 'three';

/** World directions: the large softbox above, and where the fill comes from (both of length one). */
const CEILING = 'vec3( 0.17, -0.22, 0.961 )';
const FILL = 'vec3( -0.609, 0.711, 0.355 )';

const STUDIO = /* glsl */ `
  #include <lights_fragment_end>
  #if NUM_HEMI_LIGHTS > 0
  {
    vec3 skyLight = hemisphereLights[ 0 ].skyColor * RECIPROCAL_PI;
    vec3 floorLight = hemisphereLights[ 0 ].groundColor * RECIPROCAL_PI;
    float fromFill = saturate( dot( normal, ( viewMatrix * vec4( ${FILL}, 0.0 ) ).xyz ) );
    reflectedLight.indirectDiffuse += 0.4 * fromFill * skyLight * material.diffuseContribution;
    #ifndef USE_ENVMAP
      vec3 mirrored = reflect( - geometryViewDir, normal );
      float rise = dot( mirrored, viewMatrix[ 2 ].xyz );
      float soft = 0.05 + 0.6 * material.roughness * material.roughness;
      float above = dot( mirrored, ( viewMatrix * vec4( ${CEILING}, 0.0 ) ).xyz );
      float ceiling = smoothstep( 0.72 - soft, 0.72 + soft, above ) / ( 1.0 + 1.5 * soft );
      float strip = smoothstep( 0.2 + soft, 0.1, abs( rise - 0.2 ) ) / ( 1.0 + 4.0 * soft );
      vec3 seen = mix( 0.55 * floorLight, 0.5 * skyLight, smoothstep( - soft, soft, rise ) ) + ( 2.6 * ceiling + 0.7 * strip ) * skyLight;
      reflectedLight.indirectSpecular += seen * ( material.specularColorBlended * material.dfg.x + material.specularF90 * material.dfg.y );
    #endif
  }
  #endif
`;

/** Adds the studio to a surface's shader. */
export function lightInStudio(surface: MeshStandardMaterial): void {
  surface.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace('#include <lights_fragment_end>', STUDIO);
  };
  surface.customProgramCacheKey = () => 'studio';
}
