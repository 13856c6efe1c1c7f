// @vitest-environment happy-dom
// The help: one glossary for page and documents, documents that are read as they are written, every licence named.
import { readdirSync, readFileSync } from 'node:fs';
import { cleanup, screen, waitFor } from '@testing-library/preact';
import { afterEach, expect, test } from 'vitest';
import { draw } from '../../../tests/ui/page.tsx';
import { licencesOf } from '../../../scripts/licences.ts';
import { glossary, idOf } from '../../ui/glossary.ts';
import { Licences } from './about.tsx';
import { Documents } from './documents.tsx';
import { HelpLink } from '../../ui/kit/helpLink.tsx';
import { Markdown } from '../../ui/kit/markdown.tsx';

afterEach(cleanup);

test('the glossary is in alphabetical order, each word once, each with a meaning', () => {
  const terms = glossary.map(({ term }) => term.toLowerCase());
  expect(terms).toEqual([...new Set(terms)].sort());
  expect(glossary.filter(({ meaning }) => meaning.length < 40)).toEqual([]);
});

test('every term that the page marks is in the glossary', () => {
  const sources = readdirSync('src', { recursive: true, encoding: 'utf8' }).filter(
    (file) => file.endsWith('.tsx') && !file.includes('.test.'),
  );
  const used = sources.flatMap((file) => [...readFileSync(`src/${file}`, 'utf8').matchAll(/<Term id="([^"]+)"/g)]);
  const known = new Set(glossary.map(({ term }) => idOf(term)));
  expect(used.length).toBeGreaterThan(5);
  expect(used.map(([, id]) => id!).filter((id) => !known.has(id))).toEqual([]);
});

test('documents are read as they are written: headings, lists, tables, code, links; no markup passes through', () => {
  let opened = '';
  draw(
    <Markdown
      text={
        '# Title\nText with `code`, **strong** and [another](csv-format.md#x), [outside](src/x.ts).\n\n- one\n  and more\n- two\n\n| a | b |\n|---|---|\n| 1 | <b>2</b> |\n\n```\nrun `x`\n```\n'
      }
      linkOf={(file) => (file === 'csv-format.md' ? () => (opened = file) : null)}
    />,
  );
  expect(screen.getByRole('heading').textContent).toBe('Title');
  expect(screen.getAllByRole('listitem').map((item) => item.textContent)).toEqual(['one and more', 'two']);
  expect(screen.getAllByRole('cell').map((cell) => cell.textContent)).toEqual(['1', '<b>2</b>']);
  expect(document.querySelector('pre')!.textContent).toBe('run `x`');
  screen.getByRole('button', { name: 'another' }).click();
  expect(opened).toBe('csv-format.md');
  expect(screen.queryByRole('button', { name: 'outside' })).toBeNull();
});

test('a view’s document opens at its place', async () => {
  const { app } = draw(<HelpLink document="control.md#reachability" title="Analysis" />);
  screen.getByRole('button', { name: 'Help on Analysis' }).click();
  expect(app.state.dialog.peek()).toBe('keys');
  let shown = '';
  HTMLElement.prototype.scrollIntoView = function (this: HTMLElement) {
    shown = this.textContent;
  };
  draw(<Documents />, { app });
  await waitFor(() => expect(shown).toBe('Reachability'));
  app.actions.closeDialog();
  expect(app.state.document.peek()).toBeNull();
});

test('every package that the page names stands with its licence in the text beside it', () => {
  draw(<Licences />);
  const texts = licencesOf('.');
  const rows = screen.getAllByRole('row');
  expect(rows.length).toBeGreaterThan(7);
  for (const row of rows) {
    const [name, version, licence] = [...row.children].map((cell) => cell.textContent);
    const at = texts.indexOf(`\n${name} ${version}, ${licence}\n`);
    expect(at, name!).toBeGreaterThan(0);
    expect(texts.slice(at, at + 600), `the text of ${name}`).toMatch(/copyright|licen[cs]e/i);
  }
});
