/** The build leaves out of three.js what the scene never draws with: the scene must not begin to. */
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { IDLE, NEVER, UNUSED_SHADERS, leanModules, leanShader } from '../../scripts/leanThree.ts';

const folder = fileURLToPath(new URL('../../src/scene/', import.meta.url));
const sources = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.ts'));

test('no source of the scene names what is left out of three.js', () => {
  expect(sources.length).toBeGreaterThan(20);
  const names = [...Object.values(NEVER), ...Object.values(UNUSED_SHADERS)];
  const words = [
    ...[...new Set(names)].map((word) => new RegExp(`\\b\\w*${word}\\b`)),
    ...Object.values(IDLE).map(({ needed }) => needed),
  ];
  const found = sources.flatMap((name) => {
    const code = readFileSync(folder + name, 'utf8');
    return words.filter((word) => word.test(code)).map((word) => `${name}: ${word.source}`);
  });
  expect(found).toEqual([]);
});

test('no module of three.js that is built makes a material of a shader that is left out', () => {
  const shader = /\bShaderChunk\.(\w+)_(?:vert|frag)\b/g;
  const found = [...leanModules()].flatMap(([path, { code }]) =>
    path.endsWith('ShaderLib.js') ? [] : [...code.matchAll(shader)].map(([, name]) => name!),
  );
  // The room that metals mirror is drawn with the cube's.
  expect(found).toContain('cube');
  expect(found.filter((name) => name in UNUSED_SHADERS)).toEqual([]);
});

describe('a shader without what is never on', () => {
  test.each([
    ['a branch', '#ifdef USE_SHEEN\na;\n#endif\nb;', 'b;\n'],
    ['the other branch stays', '#ifdef USE_SHEEN\na;\n#else\nb;\n#endif', 'b;\n'],
    ['a branch for its absence stays', '#ifndef USE_SHEEN\na;\n#else\nb;\n#endif', 'a;\n'],
    ['branches within', '#ifdef USE_SHEEN\n#ifdef USE_MAP\na;\n#else\nb;\n#endif\n#endif\nc;', 'c;\n'],
    [
      'other switches stay',
      '#ifdef USE_MAP\n\ta; // why\n#else\n\tb;\n#endif',
      '#ifdef USE_MAP\na;\n#else\nb;\n#endif\n',
    ],
    [
      'lights of a kind',
      '#if ( NUM_SPOT_LIGHTS > 0 )\na;\n#endif\n#if NUM_DIR_LIGHTS > 0\nb;\n#endif',
      '#if NUM_DIR_LIGHTS > 0\nb;\n#endif\n',
    ],
    [
      'a condition of several stays',
      '#if defined( USE_SHEEN ) || defined( USE_MAP )\na;\n#endif',
      '#if defined( USE_SHEEN ) || defined( USE_MAP )\na;\n#endif\n',
    ],
    ['comments', '/* one\ntwo */ a;\n', 'a;\n'],
  ])('%s', (_, glsl, lean) => expect(leanShader(glsl)).toBe(lean));

  test('what cannot be taken apart is refused', () => {
    expect(() => leanShader('#ifdef USE_SHEEN\n#elif defined( USE_MAP )\n#endif')).toThrow('#elif');
    expect(() => leanShader('#ifdef USE_MAP\n')).toThrow('#endif');
  });
});
