// The gallery: every case has its pictures, a section and words to be found by; the tour's card never covers what it speaks of.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { CaseInfo } from '../../../src/app/state/cases.ts';
import { cases, systemViews } from '../../../src/core/systems/registry.ts';
import { matches, sectionOf, sectionsOf } from '../../../src/features/gallery/gallerySections.ts';
import { placeBeside } from '../../../src/features/welcome/place.ts';

const infos: readonly CaseInfo[] = cases.map(({ look, ...one }) => ({ ...one, summary: look }));
const find = (words: string) =>
  infos.filter((one) => matches(one, words, systemViews[one.scenario.system]!.meta.title)).map(({ id }) => id);

describe('pictures of the cases', () => {
  const isWebp = (path: string) => existsSync(path) && readFileSync(path).subarray(8, 12).toString('latin1') === 'WEBP';
  const wanted = cases.map(
    ({ id, figures = [] }) =>
      [
        id,
        [
          `docs/cases/${id}.webp`,
          ...figures.map((_, i) => `docs/cases/${id}-${i + 1}.webp`),
          ...['light', 'light-loop', 'dark', 'dark-loop'].map((which) => `public/cases/${id}-${which}.webp`),
        ],
      ] as const,
  );

  test.each(wanted)('%s has its own (npm run pictures -- cases)', (_, paths) => {
    expect(paths.filter((path) => !isWebp(path))).toEqual([]);
  });

  test('none is left of a case that is gone; all cards together stay small, and each loop', () => {
    const all = ['docs/cases', 'public/cases'].flatMap((folder) =>
      readdirSync(folder)
        .filter((name) => name.endsWith('.webp'))
        .map((name) => join(folder, name)),
    );
    const known = new Set(wanted.flatMap(([, paths]) => paths));
    expect(all.filter((path) => !known.has(path))).toEqual([]);
    const size = (path: string) => readFileSync(path).length;
    const [loops, cards] = [true, false].map((loop) =>
      all.filter((path) => path.startsWith('public') && path.endsWith('-loop.webp') === loop),
    ) as [string[], string[]];
    expect(cards.reduce((sum, path) => sum + size(path), 0)).toBeLessThan(500_000);
    expect(loops.filter((path) => size(path) > 60_000)).toEqual([]);
  });

  test('docs/cases.md shows each', () => {
    const page = readFileSync('docs/cases.md', 'utf8');
    const shown = wanted.flatMap(([, paths]) =>
      paths.filter((path) => path.startsWith('docs/')).map((path) => path.slice('docs/'.length)),
    );
    expect(shown.filter((path) => !page.includes(`(${path})`))).toEqual([]);
  });

  test('a picture is taken while the run lasts', () => {
    const outside = cases.filter(({ picture, figures = [], scenario }) =>
      [picture, ...figures].some(
        (shot) => shot?.time !== undefined && (shot.time < 0 || shot.time > (scenario.duration ?? 10)),
      ),
    );
    expect(outside.map(({ id }) => id)).toEqual([]);
  });
});

describe('sections and search', () => {
  test('every case stands in one section, in its order', () => {
    const placed = sectionsOf(infos).flatMap((section) => section.families.flat());
    expect(new Set(placed.map(({ id }) => id)).size).toBe(infos.length);
    expect(placed).toHaveLength(infos.length);
  });

  test('the sections are a story; the board’s own cases come first', () => {
    const at = (id: string) => sectionOf(infos.find((one) => one.id === id)!);
    expect(
      ['ridden', 'caster-rotation', 'hanging', 'stiff-decay-euler-4', 'wheel-pendulum-lqr', 'bicycle-weave'].map(at),
    ).toEqual(['board', 'parts', 'mathematics', 'mathematics', 'control', 'mathematics']);
    expect(sectionsOf(infos)[0]!.id).toBe('board');
  });

  test('cases that differ in one thing are one card, with a value of its own for each', () => {
    const families = sectionsOf(infos).flatMap((section) => section.families);
    const together = families.filter((family) => family.length > 1).map((family) => family.map(({ id }) => id));
    expect(together).toContainEqual(['released', 'coasting-2', 'coasting-3']);
    for (const family of families.filter(({ length }) => length > 1)) {
      expect(new Set(family.map(({ among }) => among?.id)).size).toBe(1);
      expect(new Set(family.map(({ among }) => among?.value)).size).toBe(family.length);
    }
  });

  test('title, look, figure, source, system and controller are searched; all words count', () => {
    expect(find('weave')).toContain('bicycle-weave');
    expect(find('fig. 13')).toEqual(expect.arrayContaining(['stiff-decay-euler-4', 'stiff-decay-euler-8']));
    expect(find('kinugasa')).toHaveLength(4);
    expect(find('LQR cart')).toContain('cart-pendulum-lqr');
    expect(find('LQR cart')).not.toContain('cart-pendulum');
    expect(find('zebra')).toEqual([]);
    expect(find('')).toHaveLength(infos.length);
  });
});

test('a card stands within the page, and beside its target where any side has room', () => {
  const page = fc.record({ width: fc.integer({ min: 360, max: 1920 }), height: fc.integer({ min: 560, max: 1200 }) });
  fc.assert(
    fc.property(
      page,
      fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: 4, maxLength: 4 }),
      (size, [x, y, w, h]) => {
        const card = { width: 320, height: 160 };
        const target = { left: x! * size.width * 0.8, top: y! * size.height * 0.8, right: 0, bottom: 0 };
        target.right = target.left + w! * (size.width - target.left);
        target.bottom = target.top + h! * (size.height - target.top);
        const { left, top } = placeBeside(target, card, size);
        expect(left).toBeGreaterThanOrEqual(12);
        expect(top).toBeGreaterThanOrEqual(12);
        expect(left + card.width).toBeLessThanOrEqual(size.width - 12);
        expect(top + card.height).toBeLessThanOrEqual(size.height - 12);
        const room =
          size.width - target.right >= card.width + 24 ||
          target.left >= card.width + 24 ||
          size.height - target.bottom >= card.height + 24 ||
          target.top >= card.height + 24;
        const over =
          left < target.right &&
          target.left < left + card.width &&
          top < target.bottom &&
          target.top < top + card.height;
        if (room) expect(over).toBe(false);
      },
    ),
    { seed: 7 },
  );
});
