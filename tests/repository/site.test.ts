// The site's own steps: it works from any folder, and a link that leads nowhere is found.
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { expect, test } from 'vitest';
// @ts-expect-error a script without types
import { anywhere } from '../../scripts/site/anywhere.mjs';
// @ts-expect-error a script without types
import { deadLinks } from '../../scripts/site/links.mjs';
// @ts-expect-error a script without types
import { checkPages, pages } from '../../site/.vitepress/pages.mjs';

function site(files: Readonly<Record<string, string>>): (path: string) => string {
  const folder = mkdtempSync(join(tmpdir(), 'site-'));
  for (const [path, text] of Object.entries(files)) {
    mkdirSync(dirname(join(folder, path)), { recursive: true });
    writeFileSync(join(folder, path), text);
  }
  return (path) => (path === '' ? folder : readFileSync(join(folder, path), 'utf8'));
}

test('addresses below the made-up folder become the way up in pages, and sums in scripts', () => {
  const of = site({
    'docs/a.html':
      '<head></head><a href="/--s--/b.html">b</a><script>x=JSON.parse("{\\"base\\":\\"/--s--/\\"}")</script><script src="/--s--/x.js"></script>',
    'x.js': 'const a = \'/--s--/b\', c = `<i href="/--s--/d">`, both = f("/--s--/" + a, \'["/--s--/"]\');',
    'assets/x.css': '.a { background: url(/--s--/assets/y.svg) }',
  });
  anywhere(of(''), '/--s--/');
  expect(of('docs/a.html')).toBe(
    '<head><script>globalThis.__siteBase=new URL("../",location.href).pathname</script></head><a href="../b.html">b</a>' +
      '<script>x=JSON.parse(("{\\"base\\":\\""+globalThis.__siteBase+"\\"}"))</script><script src="../x.js"></script>',
  );
  expect(of('x.js')).toBe(
    'const a = (\'\'+globalThis.__siteBase+\'b\'), c = `<i href="${globalThis.__siteBase}d">`, both = f((""+globalThis.__siteBase+"") + a, (\'["\'+globalThis.__siteBase+\'"]\'));',
  );
  expect(of('assets/x.css')).toBe('.a { background: url(../assets/y.svg) }');
});

test('links without a file, without a place, bound to one folder or fetched from elsewhere are told', () => {
  const of = site({
    'index.html':
      '<a href="docs/a.html#here">1</a><a href="docs/a.html#there">2</a><a href="c.html">3</a><a href="/docs/">4</a>' +
      '<img src="https://example.org/x.png"><a href="https://example.org/">6</a><a href="docs/">7</a>',
    'docs/a.html': '<h2 id="here">Here</h2><a href="../index.html">8</a><a href="#here">9</a>',
    'docs/index.html': '',
  });
  const { links, dead } = deadLinks(of('')) as { links: number; dead: string[] };
  expect(links).toBe(9);
  expect(dead.map((line) => line.slice(0, 45))).toEqual([
    'index.html: docs/a.html#there, docs/a.html ha',
    'index.html: c.html, there is no c.html',
    'index.html: /docs/ works from one folder only',
    'index.html: https://example.org/x.png is fetc',
  ]);
});

test('every document has a place in the list of the site', () => {
  expect((pages as Set<string>).size).toBeGreaterThan(60);
  expect(checkPages).not.toThrow();
});
