import { deflateSync } from 'fflate';
import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { templates } from '../../../src/core/description/templates.ts';
import { decodeLink, descriptionInLink, encodeLink, LinkError } from '../../../src/core/scenario/link.ts';
import { packText, unpackText } from '../../../src/core/scenario/packed.ts';
import { learnSystem, systemMetas } from '../../../src/core/systems/registry.ts';

test('any text comes back, of letters, digits, - and _ alone', () => {
  fc.assert(
    fc.property(fc.string({ unit: 'grapheme', maxLength: 3000 }), (text) => {
      const packed = packText(text);
      expect(packed).toMatch(/^[\w-]*$/);
      expect(unpackText(packed, 1e5)).toBe(text);
    }),
  );
});

describe('a stranger’s packed text', () => {
  it('stops at its bound, whatever it promises', () => {
    const bomb = Buffer.from(deflateSync(new Uint8Array(50_000_000), { level: 9 })).toString('base64url');
    expect(bomb.length).toBeLessThan(70_000);
    expect(() => unpackText(bomb, 200_000)).toThrow('unpacks to more than 200000 bytes');
  });

  it('cut or changed, it is told; nothing but an Error comes of it', () => {
    const packed = packText('coordinate x\ncoordinate y\n'.repeat(40));
    for (let end = 0; end < packed.length; end++)
      expect(() => unpackText(packed.slice(0, end), 1e5), `cut at ${end}`).toThrow('is not whole');
    expect(() => unpackText(`${packed.slice(0, 9)}*${packed.slice(10)}`, 1e5)).toThrow('is not whole');
    fc.assert(
      fc.property(fc.base64String({ maxLength: 400 }), (text) => {
        try {
          unpackText(text.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', ''), 1e5);
        } catch (error) {
          expect(error).toBeInstanceOf(Error);
        }
      }),
    );
  });
});

describe('a link with a description', () => {
  const board = async (): Promise<string> => (await templates[0]!.load()).default;
  const known = { systems: systemMetas, cases: [] };
  const of = async (text: string) => {
    const { meta } = await learnSystem(text);
    const scenario = { version: 1 as const, system: meta.id, duration: 2 };
    return { scenario, link: encodeLink({ caseId: null, scenario }, known) };
  };

  test.each(templates.map(({ id, load }) => [id, load] as const))('%s is packed and comes back', async (_, load) => {
    const text = (await load()).default;
    const { scenario, link } = await of(text);
    expect(link).toContain('system.packed=');
    expect(link.length).toBeLessThan(100 + 0.6 * encodeURIComponent(text).length);
    expect(descriptionInLink(link)).toBe(text);
    expect(decodeLink(link, known)).toMatchObject({ scenario, altered: false });
  });

  it('as they were before is still read', async () => {
    const text = await board();
    const { scenario, link } = await of(text);
    const plain = link.replace(/system\.packed=[^&]*/, `system.description=${encodeURIComponent(text)}`);
    expect(descriptionInLink(plain)).toBe(text);
    expect(decodeLink(plain, known)).toMatchObject({ scenario, altered: false });
  });

  it('cut within is refused with words', async () => {
    const { link } = await of(await board());
    const broken = link.replace(/(system\.packed=[^&]*)[^&]{9}&/, '$1&');
    expect(descriptionInLink(broken)).toBe(null);
    expect(() => decodeLink(broken, known)).toThrow(LinkError);
    expect(() => decodeLink(broken, known)).toThrow('is not whole');
  });
});
