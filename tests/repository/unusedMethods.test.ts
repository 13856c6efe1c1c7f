/** The build leaves out of three.js the methods that nobody names, and only these. */
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { leanModules } from '../../scripts/leanThree.ts';
import { withoutUnused } from '../../scripts/unusedMethods.ts';

const gone = (library: string, ...users: string[]): readonly string[] =>
  withoutUnused(new Map([['a.js', library]]), users).get('a.js')!.gone;

describe('a method', () => {
  test.each([
    ['that nobody names goes', 'class A { go() {} stay() {} }', 'a.stay()', ['go']],
    ['that its own module calls stays', 'class A { b() {} }\nnew A().b();', '', []],
    ['that only one that goes calls goes too', 'class A { a() { this.b(); } b() {} }', '', ['a', 'b']],
    ['that one that stays calls stays', 'class A { a() { this.b(); } b() {} }', 'x.a()', []],
    [
      'of one name in two classes goes or stays in both',
      'class A { a() {} }\nclass B { a() { super.a(); } }',
      '',
      ['a', 'a'],
    ],
    ['named in a string stays', "class A { a() {} }\nx['a']();", '', []],
    ['named in a template stays', 'class A { a() {} }\nf(`a`);', '', []],
    ['taken out of an object stays', 'class A { a() {} }\nconst { a: b } = x;', '', []],
    ['that a caller names in any way stays', 'class A { a() {} }', 'const { a } = x;', []],
    ['with a computed name stays', 'class A { [Symbol.iterator]() {} }', '', []],
    ['that is called without a name stays', 'class A { constructor() {} toString() {} valueOf() {} }', '', []],
    [
      'read or written as a property goes like any other',
      'class A { get a() {} set a(x) {} get b() {} }',
      'x.b',
      ['a', 'a'],
    ],
    ['written only by others stays', 'class A { set a(x) {} }\nnew A().a = 1;', '', []],
    ['that a constructor gives goes', 'function A() { this.a = function () {}; this.b = 1; }', '', ['a']],
    ['that a constructor gives by its name goes', 'function A() { function a() {} this.a = a; }', '', ['a']],
    ['that a constructor gives and calls stays', 'function A() { this.a = function () {}; this.a(); }', '', []],
  ])('%s', (_, library, user, names) => expect(gone(library, user)).toEqual(names));

  test('is cut out whole, and the rest stays to the letter', () => {
    const library = 'class A {\n\ta() { return { b: 1 }; }\n\tc() { return 2; }\n}\n';
    expect(withoutUnused(new Map([['a.js', library]]), ['c']).get('a.js')!.code).toBe(
      'class A {\n\t\n\tc() { return 2; }\n}\n',
    );
  });
});

describe('of three.js', () => {
  const modules = leanModules();
  const at = (name: string) => [...modules].find(([path]) => path.endsWith(name))![1];

  test('what the scene takes is found, and what it never takes is not', () => {
    const paths = [...modules.keys()].join('\n');
    for (const name of ['WebGLRenderer.js', 'Mesh.js', 'OrbitControls.js', 'GLTFExporter.js'])
      expect(paths).toContain(name);
    expect(paths).not.toContain('SkinnedMesh.js');
  });

  test('what the scene calls stays, what it never calls goes', () => {
    expect(at('Object3D.js').gone).toContain('toJSON');
    expect(at('Vector3.js').gone).toContain('manhattanLength');
    expect(at('Vector3.js').gone).not.toContain('copy');
    expect(at('WebGLRenderer.js').gone).not.toContain('render');
    const [path] = [...modules].find(([name]) => name.endsWith('Vector3.js'))!;
    expect(readFileSync(path, 'utf8').length).toBeGreaterThan(at('Vector3.js').code.length);
  });
});
