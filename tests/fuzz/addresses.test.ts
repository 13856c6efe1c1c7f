import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { fileAddress } from '../../src/app/files/fileAddress.ts';
import { fromText } from '../../src/app/persistence/savedWork.ts';
import { cases } from '../../src/core/systems/registry.ts';
import { collectScenarioErrors } from '../../src/core/scenario/schema.ts';
import { decodeLink, encodeLink, LinkError } from '../../src/core/scenario/link.ts';
import { metas } from '../helpers.ts';
import { awkward, damaged } from './damage.ts';
import { runs, SEED, tally } from './tally.ts';

/** What an address or the browser's storage brings: opened, or refused with what and where. */

const systems = metas;
const settings = { seed: SEED };

describe('links', () => {
  const count = tally('links');
  const good = fc.constantFrom(...cases).map(({ id, scenario }) =>
    encodeLink(
      {
        caseId: id,
        scenario: { ...scenario, duration: 1.5 },
        tool: 'plots',
        view: 'side',
        time: 0.5,
        plots: { own: { key: 'a', panes: [] } },
      },
      { cases, systems },
    ),
  );
  const entry = fc
    .tuple(
      fc.oneof(
        awkward,
        fc.constantFrom(
          'v',
          'case',
          'sum',
          'initial.alpha',
          'parameters.rodMass',
          'control.type',
          'method',
          'method.name',
          'inputs.tau_fp',
          'hold',
          '__proto__.duration',
          'constructor.prototype.x',
          'initial..x',
          '.',
          '0.1.2',
        ),
      ),
      fc.oneof(awkward, fc.constantFrom('1', '-', '"x"', '[]', '{"a":1}', '%', '%ff', '1e999')),
    )
    .map(([name, value]) => `${name}=${value}`);
  const link = fc.oneof(
    damaged(good),
    fc.tuple(good, fc.array(entry, { maxLength: 4 })).map(([text, more]) => [text, ...more].join('&')),
    fc.array(entry, { maxLength: 6 }).map((list) => `#v=1&${list.join('&')}&sum=0`),
    fc.string(),
  );

  test('a scenario that may run, or refused with a place', () => {
    fc.assert(
      fc.property(link, (text) => {
        try {
          const { scenario } = decodeLink(text, { systems, cases });
          expect([...collectScenarioErrors(scenario, systems)]).toEqual([]);
          count('opened');
        } catch (error) {
          if (!(error instanceof LinkError)) throw error;
          expect(error.message.length).toBeGreaterThan(8);
          expect(error.message.length).toBeLessThan(2000);
          count('refused');
        }
        expect({}).not.toHaveProperty('duration');
      }),
      { ...settings, numRuns: runs(1500) },
    );
  });
});

describe('kept work', () => {
  const count = tally('kept work');
  const known = {
    systems,
    cases: cases.map(({ id, title, look, scenario }) => ({ id, title, summary: look, scenario })),
    toolIds: ['now', 'plots'],
  };
  const good = fc
    .tuple(fc.uniqueArray(fc.constantFrom(...cases), { minLength: 1, maxLength: 4 }), fc.boolean())
    .map(([list, own]) =>
      JSON.stringify({
        version: 1,
        system: list[0]!.scenario.system,
        file: 'ride.csv',
        settings: { theme: 'dark', tool: 'plots', speed: 0.5, look: { names: true } },
        drafts: list.map(({ id, scenario }) => ({
          origin: own ? { title: id, scenario } : id,
          draft: { ...scenario, duration: 2 },
        })),
      }),
    );
  const text = fc.oneof(damaged(good), fc.json({ maxDepth: 4 }), fc.string());

  test('drafts that may run, or refused with a reason', () => {
    fc.assert(
      fc.property(text, (stored) => {
        let saved;
        try {
          saved = fromText(stored, known);
        } catch (error) {
          expect((error as Error).message.length).toBeGreaterThan(5);
          return count('refused');
        }
        for (const { draft, origin } of saved.work.drafts.values())
          for (const scenario of [draft, origin.scenario])
            expect([...collectScenarioErrors(scenario, systems)]).toEqual([]);
        expect([undefined, null, ...known.toolIds]).toContain(saved.settings.tool);
        count('taken');
      }),
      { ...settings, numRuns: runs(1500) },
    );
  });
});

describe('?file=', () => {
  const count = tally('file addresses');
  const part = fc.oneof(
    fc.constantFrom(
      '/',
      '\\',
      ':',
      '//',
      '@',
      '..',
      '.csv',
      '.json',
      'https',
      'javascript',
      'data',
      '%2f',
      '\t',
      '\n',
      '?',
      '#',
      'evil.example',
      '\u3002',
      '%00',
    ),
    awkward,
    fc.string({ maxLength: 3 }),
  );

  test('a table or scenario of this origin, or refused', () => {
    fc.assert(
      fc.property(fc.array(part, { maxLength: 8 }), (parts) => {
        let address: URL;
        try {
          address = fileAddress(parts.join(''), 'https://lab.example/a/b/');
        } catch (error) {
          expect((error as Error).message.length).toBeGreaterThan(5);
          return count('refused');
        }
        expect([address.origin, address.username, address.password, address.hash]).toEqual([
          'https://lab.example',
          '',
          '',
          '',
        ]);
        expect(address.pathname).toMatch(/\.(csv|txt|json)$/i);
        count('allowed');
      }),
      { ...settings, numRuns: runs(3000) },
    );
  });
});
