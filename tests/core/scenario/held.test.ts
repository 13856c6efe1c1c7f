import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { heldOf, holdingOf } from '../../../src/core/scenario/held.ts';
import { collectScenarioErrors } from '../../../src/core/scenario/schema.ts';
import { gaitScenario, plainGait } from '../../../src/core/gait/gait.ts';
import { metas, scenarioOf } from '../../helpers.ts';

const meta = metas['ripstik-rider']!;
const rider = (file: object = {}) => ({ version: 1, system: 'ripstik-rider', ...file });
const hold = (file: object) => scenarioOf(rider(file)).hold;

describe('what is held by default', () => {
  it.each([
    ['stays held', {}, ['crouch', 'twist']],
    ['stays held beside what a file holds', { hold: ['beta'] }, ['beta', 'crouch', 'twist']],
    ['is released by name', { release: ['twist'] }, ['crouch']],
    ['is released beside what a file holds', { hold: ['beta'], release: ['crouch', 'twist'] }, ['beta']],
    ['is free where hold is empty', { hold: [] }, []],
    ['is taken as it stands where hold names one of them', { hold: ['crouch'] }, ['crouch']],
  ])('%s', (_, file, right) => {
    expect(hold(file)).toEqual(right);
  });

  it('is nothing in a system that says nothing of it', () => {
    expect(scenarioOf({ version: 1, system: 'ripstik' }).hold).toEqual([]);
  });

  it('reads the same again once it has been checked', () => {
    fc.assert(
      fc.property(
        fc.option(fc.uniqueArray(fc.constantFrom(...meta.coordinates.map(({ name }) => name)), { maxLength: 5 }), {
          nil: undefined,
        }),
        fc.uniqueArray(fc.constantFrom(...meta.held!)),
        (held, release) => {
          fc.pre(!held?.some((name) => release.includes(name)));
          const checked = scenarioOf(rider({ ...(held ? { hold: held } : {}), release }));
          const again = { hold: checked.hold, ...(checked.release ? { release: checked.release } : {}) };
          expect(hold(again)).toEqual(checked.hold);
        },
      ),
    );
  });

  it('is said in few words, and those mean the same', () => {
    fc.assert(
      fc.property(fc.uniqueArray(fc.constantFrom(...meta.coordinates.map(({ name }) => name))), (names) => {
        const said = holdingOf(meta, names);
        expect(new Set(heldOf(meta, said))).toEqual(new Set(names));
        expect(collectScenarioErrors(rider(said), metas).size).toBe(0);
      }),
    );
    expect(holdingOf(meta, ['crouch', 'twist'])).toEqual({});
  });

  it.each([
    ['held', {}, ['beta', 'crouch', 'twist']],
    ['free', { hold: [] }, ['beta']],
    ['one of them', { release: ['twist'] }, ['beta', 'crouch']],
  ])('stays what it is in a gait, which holds the lean: %s', (_, base, right) => {
    expect(scenarioOf(gaitScenario(meta, plainGait, base)).hold).toEqual(right);
  });
});

describe('a release that can not be', () => {
  const errors = (file: object) => [...collectScenarioErrors(file, metas)];
  it.each([
    [rider({ hold: ['X', 'crouch'], release: ['crouch'] }), 'release[0]', /"crouch" is in "hold" too/],
    [rider({ release: ['beta'] }), 'release[0]', /crouch, twist/],
    [{ version: 1, system: 'ripstik', release: ['alpha'] }, 'release', /ripstik holds nothing by default/],
    [
      rider({ release: ['twist'], parameters: { riderIzz: 0.5 } }),
      'parameters.hipIzz',
      /0.6 kg·m² is more than riderIzz \(0.5 kg·m²\), a part of which it is while twist is free/,
    ],
  ])('is refused by its path', (file, path, words) => {
    expect(errors(file).map(([at]) => at)).toEqual([path]);
    expect(errors(file)[0]![1]).toMatch(words);
  });

  it('takes a rider of any inertia whose hips are held', () => {
    expect(errors(rider({ parameters: { riderIzz: 0.1 } }))).toEqual([]);
  });
});
