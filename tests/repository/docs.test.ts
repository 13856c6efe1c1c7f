// What the code says of itself: every function declaration that `core` exports names its arguments; every decision is numbered, dated and
// listed; every link of a document leads somewhere.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import ts from 'typescript';
import { describe, expect, test } from 'vitest';

const CORE = 'src/core';
const DECISIONS = 'docs/decisions';

const files = readdirSync(CORE, { recursive: true, encoding: 'utf8' })
  .filter((file) => file.endsWith('.ts') && !file.includes('.generated.'))
  .map((file) => join(CORE, file));

/**
 * Arguments that an exported function has and no `@param` names, as `file function: argument`. Destructured ones say what they
 * are, and so do the arrow functions of one line (`add`, `isOwn`), which are not looked at.
 */
function unnamed(file: string): string[] {
  const source = ts.createSourceFile(file, readFileSync(file, 'utf8'), ts.ScriptTarget.Latest, true);
  return source.statements.flatMap((statement) => {
    if (!ts.isFunctionDeclaration(statement)) return [];
    if (!statement.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword)) return [];
    const told = new Set(
      ts
        .getJSDocTags(statement)
        .filter(ts.isJSDocParameterTag)
        .map((tag) => tag.name.getText()),
    );
    return statement.parameters
      .filter(({ name }) => ts.isIdentifier(name) && !told.has(name.text))
      .map(({ name }) => `${file} ${statement.name?.text ?? 'default'}: ${name.getText()}`);
  });
}

describe('docstrings of core', () => {
  test('there are files', () => expect(files.length).toBeGreaterThan(150));

  test('every exported function declaration names its arguments', () => expect(files.flatMap(unnamed)).toEqual([]));
});

describe('decisions', () => {
  const index = readFileSync(join(DECISIONS, 'README.md'), 'utf8');
  const decisions = readdirSync(DECISIONS).filter((file) => file !== 'README.md');

  test('are numbered from 1 on, none left out', () => {
    expect(decisions.map((file) => file.slice(0, 5))).toEqual(
      decisions.map((_, i) => `${String(i + 1).padStart(4, '0')}-`),
    );
  });

  test.each(decisions)('%s says its state and date, and is listed with it', (file) => {
    const state = readFileSync(join(DECISIONS, file), 'utf8').split('\n')[2]!;
    expect(state).toMatch(/^(Accepted|Replaced by \d{4}), \d{4}-\d{2}-\d{2}$/);
    const line = index.split('\n').find((row) => row.includes(`](${file})`));
    expect(line).toContain(`| ${state} |`);
  });
});

describe('links of the documents', () => {
  const markdown = [
    '.',
    'docs',
    DECISIONS,
    'docs/pictures',
    'lessons',
    'site',
    'src/compute',
    'src/core/integrators',
  ].flatMap((folder) => readdirSync(folder).flatMap((file) => (file.endsWith('.md') ? [join(folder, file)] : [])));
  const textOf = (file: string): string => readFileSync(file, 'utf8').replace(/^```[^]*?^```/gm, '');
  /** As GitHub names a heading, and `site/.vitepress/markdown.mjs` too. */
  const anchorsOf = (file: string): string[] =>
    [...textOf(file).matchAll(/^#+ (.+)$/gm)].map(([, heading]) =>
      heading!
        .trim()
        .toLowerCase()
        .replace(/[^\p{L}\p{N}\p{M} _-]/gu, '')
        .replaceAll(' ', '-'),
    );

  test('lead to a file, and to a heading of it', () => {
    const dead: string[] = [];
    let links = 0;
    for (const file of markdown)
      for (const [, target] of textOf(file)
        .replace(/`[^`\n]*`/g, '')
        .matchAll(/\]\(([^)\s]+)\)/g)) {
        if (/^[a-z]+:/.test(target!)) continue;
        links++;
        const [path = '', anchor] = target!.split('#');
        const there = path === '' ? file : join(dirname(file), path);
        if (!existsSync(there)) dead.push(`${file}: ${target}`);
        else if (anchor !== undefined && !anchorsOf(there).includes(anchor)) dead.push(`${file}: ${target}`);
      }
    expect(links).toBeGreaterThan(200);
    expect(dead).toEqual([]);
  });
});
