// A rider drawn from what carries it stands where the derivation has it.
import { expect, test } from 'vitest';
import { systemViews } from '../../../src/core/systems/registry.ts';
import { poses as bicycleRider } from '../../../src/core/systems/bicycle-rider/poses.generated.ts';
import { poses as ripstikRider } from '../../../src/core/systems/ripstik-rider/poses.generated.ts';
import { seeded } from '../../helpers.ts';

const SEED = 5;

test.each([
  ['bicycle-rider', bicycleRider],
  ['ripstik-rider', ripstikRider],
])('%s, at random states', (id, derived) => {
  const { meta, poses } = systemViews[id]!;
  const random = seeded(SEED);
  for (let i = 0; i < 20; i++) {
    const q = Float64Array.from(meta.coordinates, () => 2 * random() - 1);
    const p = Float64Array.from(meta.parameters, (parameter) => parameter.default * (0.5 + random()));
    const [own, known] = [new Float64Array(12 * meta.bodies.length), new Float64Array(12 * meta.bodies.length)];
    poses(q, p, own);
    derived(q, p, known);
    own.forEach((x, k) => expect(Math.abs(x - known[k]!), `seed ${SEED}, state ${i}, number ${k}`).toBeLessThan(1e-13));
  }
});
