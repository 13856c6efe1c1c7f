// VitePress builds for one folder of a server. Built for a made-up one, the site works from any: in pages and style sheets the
// made-up folder becomes the way to the site's, in scripts what the page says of where it was loaded from.
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { parseAst } from 'rolldown/parseAst';

const HERE = 'globalThis.__siteBase';

/**
 * Relative links are those of the page that was loaded; the router changes the address under what it keeps, as the bar at the top. Runs
 * once all is there, before the page's own scripts.
 */
const FIX = `for(const e of document.querySelectorAll('a[href],link[rel=icon]'))if(!/^(#|[a-z]+:)/i.test(e.getAttribute('href')))e.setAttribute('href',e.href.slice(location.origin.length))`;

/** Paths below a folder with one of the endings. */
export function filesIn(folder, ending) {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => ending.test(path) && statSync(join(folder, path)).isFile());
}

/** From a page of the site to its folder: `./`, `../../`. */
const wayUp = (page) => `${posix.relative(posix.dirname(page), '.') || '.'}/`;

/**
 * @param site folder with what VitePress built, and nothing else
 * @param base the folder it was built for
 */
export function anywhere(site, base) {
  const change = (path, by) => {
    const text = readFileSync(join(site, path), 'utf8');
    if (text.includes(base)) writeFileSync(join(site, path), by(text, path));
  };
  for (const path of filesIn(site, /\.html$/)) change(path, (text) => inPage(text, base, wayUp(path)));
  for (const path of filesIn(site, /\.css$/)) change(path, (text) => text.replaceAll(base, wayUp(path)));
  for (const path of filesIn(site, /\.js$/)) change(path, (text) => inScript(text, base));
  const left = filesIn(site, /\.(html|css|js|json)$/).filter((path) =>
    readFileSync(join(site, path), 'utf8').includes(base),
  );
  if (left.length > 0) throw new Error(`These files of the site still name ${base}: ${left.join(', ')}`);
}

function inPage(text, base, up) {
  const where = `<script>${HERE}=new URL(${JSON.stringify(up)},location.href).pathname</script>`;
  return text
    .split(/(<script(?![^>]*\bsrc=)[^>]*>[^]*?<\/script>)/)
    .map((part, k) =>
      k % 2 === 0
        ? part.replaceAll(base, up)
        : part.replace(/>([^]*)<\/script>$/, (_, code) => `>${inScript(code, base)}</script>`),
    )
    .join('')
    .replace('<head>', `<head>${where}`)
    .replace('</body>', `<script>${FIX}</script></body>`);
}

/** Every string that names the base becomes a sum. */
function inScript(code, base) {
  if (!code.includes(base)) return code;
  const strings = [];
  const look = (node) => {
    if (!node || typeof node !== 'object') return;
    if (Array.isArray(node)) return node.forEach(look);
    const text = node.type === 'Literal' && typeof node.value === 'string';
    if (text || node.type === 'TemplateElement') strings.push(node);
    else Object.values(node).forEach(look);
  };
  look(parseAst(code));
  strings.sort((a, b) => b.start - a.start);
  for (const { type, start, end } of strings) {
    const raw = code.slice(start, end);
    if (!raw.includes(base)) continue;
    const sum =
      type === 'TemplateElement'
        ? raw.replaceAll(base, `\${${HERE}}`)
        : `(${raw.replaceAll(base, `${raw[0]}+${HERE}+${raw[0]}`)})`;
    code = code.slice(0, start) + sum + code.slice(end);
  }
  parseAst(code);
  return code;
}
