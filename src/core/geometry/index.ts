import type { Model } from './drawing.ts';
import { casterBody } from './caster.ts';
import { type Dimensions, dimensionsOf } from './dimensions.ts';
import { backPlateBody, frontPlateBody } from './plate.ts';
import { rodBody } from './rod.ts';
import { type Body, writeMaterials, writeMesh } from './wavefront.ts';

export type ModelName = 'rod' | 'front-plate' | 'back-plate' | 'caster';

export type { Model };

const builders: Record<ModelName, (d: Dimensions) => Body> = {
  rod: rodBody,
  'front-plate': frontPlateBody,
  'back-plate': backPlateBody,
  caster: casterBody,
};

export const modelNames: readonly ModelName[] = ['rod', 'front-plate', 'back-plate', 'caster'];

/**
 * Meshes of the board's bodies in the proportions of its parameters (metres, radians; missing or
 * non-finite ones take their defaults). Same parameters, same bytes.
 */
export function generateModels(parameters: Readonly<Record<string, number>>): Record<ModelName, Model> {
  const dimensions = dimensionsOf(parameters);
  const model = (name: ModelName): Model => {
    const body = builders[name](dimensions);
    return { mdl: writeMesh(body), mat: writeMaterials(body) };
  };
  return {
    rod: model('rod'),
    'front-plate': model('front-plate'),
    'back-plate': model('back-plate'),
    caster: model('caster'),
  };
}

/**
 * Where the wheel turns, in the caster model's frame: group `wheel` spins about `axis` through `hub`.
 */
export function wheelAxle(parameters: Readonly<Record<string, number>>): {
  hub: readonly [number, number, number];
  axis: readonly [number, number, number];
} {
  return { hub: dimensionsOf(parameters).hub, axis: [0, 1, 0] };
}
