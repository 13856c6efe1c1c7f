// What is stored comes back; what is stored by another hand, or asked for from elsewhere, is refused by name.
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { plotsFrom } from '../../../src/app/state/plotPanes.ts';
import { fileAddress } from '../../../src/app/files/fileAddress.ts';
import { fromText, toText, type SavedState } from '../../../src/app/persistence/savedWork.ts';
import { cases, systemViews } from '../../../src/core/systems/registry.ts';

const SEED = { seed: 20261124 };
const known = {
  systems: Object.fromEntries(Object.entries(systemViews).map(([id, { meta }]) => [id, meta])),
  cases: cases.map(({ id, title, look, scenario }) => ({ id, title, summary: look, scenario })),
  toolIds: ['now', 'plots'],
};
const [first] = known.cases;
const sleigh = known.cases.find((c) => c.id === 'chaplygin-sleigh')!;
const own = { id: '', title: 'mine', summary: '', scenario: { version: 1 as const, system: 'bicycle', duration: 3 } };
const saved: SavedState = {
  work: {
    draft: { ...first!.scenario, duration: 2 },
    origin: first!,
    drafts: new Map([
      [first!.scenario.system, { draft: { ...first!.scenario, duration: 2 }, origin: first! }],
      [sleigh.scenario.system, { draft: sleigh.scenario, origin: sleigh }],
      ['bicycle', { draft: own.scenario, origin: own }],
    ]),
    file: 'ride.csv',
  },
  settings: {
    theme: 'dark',
    tool: 'plots',
    view: 'side',
    follow: false,
    showTrails: true,
    showForces: true,
    loop: true,
    speed: 0.25,
    plots: {
      own: { key: 'ripstik/ridden', panes: [{ title: 'Path', x: 'X', y: ['Y'], equal: true }] },
      degrees: false,
      wrapped: true,
    },
    showNames: true,
    levelHorizon: false,
    quality: 'low',
  },
};

describe('stored work', () => {
  test('comes back whole, and what is a case as it stands is the very case', () => {
    const back = fromText(toText(saved), known);
    expect(back).toEqual(saved);
    expect(back.work.drafts.get('chaplygin-sleigh')!.draft).toBe(sleigh.scenario);
  });

  test('changed by another hand: read as far as it holds, or refused with a reason', () => {
    const text = toText(saved);
    fc.assert(
      fc.property(
        fc.nat({ max: text.length }),
        fc.nat({ max: 40 }),
        fc.oneof(fc.string({ maxLength: 6 }), fc.constantFrom('null', '{}', '"__proto__":1,', '1e999', '-1')),
        (at, cut, put) => {
          try {
            const { work, settings } = fromText(text.slice(0, at) + put + text.slice(at + cut), known);
            expect(known.systems).toHaveProperty(work.draft.system);
            expect([undefined, null, ...known.toolIds]).toContain(settings.tool);
          } catch (error) {
            expect(error).toBeInstanceOf(Error);
            expect((error as Error).message.length).toBeGreaterThan(5);
          }
          expect(Object.prototype).not.toHaveProperty('1');
        },
      ),
      { ...SEED, numRuns: 500 },
    );
  });

  test.each([
    ['of another version', { version: 2 }, /version 2/],
    ['without a draft', { version: 1, system: 'ripstik', drafts: [] }, /no draft/],
    [
      'with a draft that cannot run',
      {
        version: 1,
        system: 'ripstik',
        drafts: [{ origin: 'ridden', draft: { version: 1, system: 'ripstik', duration: 0 } }],
      },
      /^duration: must be greater than 0/,
    ],
    [
      'of an unknown case',
      { version: 1, system: 'ripstik', drafts: [{ origin: 'nowhere', draft: null }] },
      /no case is called "nowhere"/,
    ],
  ])('%s', (_, raw, reason) => {
    expect(() => fromText(JSON.stringify(raw), known)).toThrow(reason);
  });
});

test('plots of another shape are passed over', () => {
  const pane = { title: '', x: 't', y: ['X'] };
  const plots = (own: unknown) => plotsFrom({ own, degrees: true, wrapped: false });
  expect(plots({ key: 'a/b', panes: [pane] })).not.toBeNull();
  for (const bad of [
    { ...pane, y: 'X' },
    { ...pane, y: [1] },
    { ...pane, x: null },
    { ...pane, to: 'end' },
    { ...pane, exact: { label: '', expression: 'while(1)' } },
    null,
    [],
  ])
    expect(plots({ key: 'a/b', panes: [bad] })).toBeNull();
  for (const bad of [undefined, 3, { key: 'a/b' }, { key: 'a/b', panes: Array(100).fill(pane) }])
    expect(plots(bad)).toBeNull();
});

describe('a file named by the address', () => {
  const page = 'https://lab.example/sub/index.html?file=x';

  test.each([
    ['data/ride.csv', 'https://lab.example/sub/data/ride.csv'],
    ['./ride.CSV', 'https://lab.example/sub/ride.CSV'],
    ['../other/case.json#part', 'https://lab.example/other/case.json'],
    ['my ride.csv', 'https://lab.example/sub/my%20ride.csv'],
  ])('%s', (file, address) => {
    expect(fileAddress(file, page).href).toBe(address);
  });

  test.each([
    'https://evil.example/x.csv',
    '//evil.example/x.csv',
    '\\\\evil.example/x.csv',
    '/\t/evil.example/x.csv',
    ' //evil.example/x.csv',
    'h\nttps://evil.example/x.csv',
    'javascript:x.csv',
    'data:text/csv,t.csv',
    'blob:https://lab.example/x.csv',
    '/x.csv',
    'x.html',
    'x.csv.exe',
    '',
  ])('not %j', (file) => {
    expect(() => fileAddress(file, page)).toThrow();
  });

  test('whatever is asked for, nothing but a file of this origin is fetched', () => {
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
        '%2f',
        '\t',
        '\n',
        '?',
        '#',
        'evil.example',
      ),
      fc.string({ maxLength: 3 }),
    );
    fc.assert(
      fc.property(fc.array(part, { maxLength: 8 }), (parts) => {
        let address: URL;
        try {
          address = fileAddress(parts.join(''), page);
        } catch {
          return;
        }
        expect(address.origin).toBe('https://lab.example');
        expect(address.pathname).toMatch(/\.(csv|txt|json)$/i);
      }),
      { ...SEED, numRuns: 3000 },
    );
  });
});
