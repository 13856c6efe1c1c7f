// What the repository's documents need beyond plain Markdown: links as they stand in the repository, formulas, the parts of a
// lesson, and the words of the glossary where a page uses one first.
import { existsSync, statSync } from 'node:fs';
import { join, posix, relative } from 'node:path';
import katex from 'katex';
import { addressOf, pages, root } from './pages.mjs';

/** Words that the documents use in other senses too. */
const AMBIGUOUS = new Set(['cost', 'draft', 'help', 'method', 'mode', 'reachable', 'report', 'stage', 'tracked']);

/** A heading's id, as GitHub makes it: links work there and here. */
export const slug = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M} _-]/gu, '')
    .replaceAll(' ', '-');

const escape = (text) => text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/** `v-pre`: the page compiler finds double braces in formulas. */
const formula = (latex, displayMode) =>
  katex.renderToString(latex, { displayMode, throwOnError: true, strict: 'ignore' }).replace('<span', '<span v-pre');

/**
 * @param md the site's markdown-it
 * @param data of scripts/site-data.ts
 * @param files to which each file of the repository that a page links is added: it belongs on the site too
 */
export function documents(md, { lessons, glossary }, files) {
  // A heading alone, which becomes a title, comes without its place.
  const sourceOf = ({ realPath, path = realPath }) => path && relative(root, realPath ?? path).replaceAll('\\', '/');
  links(md, sourceOf, files);
  mathematics(md);
  parts(md, sourceOf, lessons);
  terms(md, sourceOf, glossary);
}

/** Where a link of a page leads on the site; null: to nothing that is part of it, and its words alone stay. */
function targetOf(href, source, files) {
  const [path, anchor = ''] = href.split('#');
  const file = posix.normalize(posix.join(posix.dirname(source), path)).replace(/\/$/, '');
  const page = [file, `${file}/README.md`].find((one) => pages.has(one));
  const from = posix.dirname(addressOf(source));
  const to = (address) => `${posix.relative(from, address) || '.'}${anchor ? `#${anchor}` : ''}`;
  if (page) return to(addressOf(page).replace(/\.md$/, '.html'));
  if (!existsSync(join(root, file))) throw new Error(`${source}: the link ${href} leads to nothing`);
  if (!statSync(join(root, file)).isFile()) return null;
  if (file.startsWith('public/')) return to(file.replace('public', 'app'));
  if (!/^docs\/|^(LICENSE|CITATION\.cff)$/.test(file)) return null;
  files.add(file);
  return to(file);
}

function links(md, sourceOf, files) {
  md.core.ruler.push('repository-links', ({ tokens, env }) => {
    const source = sourceOf(env);
    if (!source) return;
    for (const { children } of tokens) {
      const open = [];
      for (const token of children ?? []) {
        if (token.type === 'link_open') {
          const href = token.attrGet('href');
          open.push(token);
          if (/^[a-z]+:|^#|^\/\//i.test(href)) continue;
          const target = targetOf(decodeURI(href), source, files);
          if (target !== null) token.attrSet('href', target);
          else [token.tag, token.attrs, token.meta] = ['span', [], { plain: true }];
          // A file, not a page: the router has nothing for it.
          if (target !== null && !/\.html(#|$)/.test(target)) token.attrSet('target', '_self');
        }
        if (token.type === 'link_close' && open.pop()?.meta?.plain) token.tag = 'span';
      }
    }
  });
  const usual = md.renderer.rules.link_open;
  md.renderer.rules.link_open = (tokens, at, options, env, self) =>
    tokens[at].meta?.plain ? '<span>' : usual(tokens, at, options, env, self);
}

function mathematics(md) {
  md.inline.ruler.after('escape', 'formula', (state, silent) => {
    const found = /^\$([^$\n]+(?:\n[^$\n]+)*)\$/.exec(state.src.slice(state.pos));
    if (!found) return false;
    if (!silent) state.push('formula', '', 0).content = found[1];
    state.pos += found[0].length;
    return true;
  });
  md.renderer.rules.formula = (tokens, at) => formula(tokens[at].content, false);
}

/** Fenced blocks that are no code. */
function parts(md, sourceOf, lessons) {
  const usual = md.renderer.rules.fence;
  md.renderer.rules.fence = (tokens, at, options, env, self) => {
    const { info, content } = tokens[at];
    const kind = info.trim();
    if (kind === 'math') return `<div class="formula">${formula(content, true)}</div>`;
    if (kind !== 'live' && kind !== 'question') return usual(tokens, at, options, env, self);
    const lesson = lessons.find(({ file }) => sourceOf(env) === `lessons/${file}`);
    const before = tokens
      .slice(0, at)
      .filter(({ type, info: other }) => type === 'fence' && /^(live|question)$/.test(other.trim()));
    const part = lesson?.parts[before.length];
    if (!part) return usual(tokens, at, options, env, self);
    if (kind === 'live') return `<LivePart title="${escape(part.title)}" link="${escape(part.link)}" />`;
    const hint = part.hint ? `<details><summary>Hint</summary>${md.renderInline(part.hint, env)}</details>` : '';
    return `<QuestionPart unit="${escape(part.unit)}" lab="${escape(lesson.link)}"><p>${md.renderInline(part.text, env)}</p>${hint}</QuestionPart>`;
  };
}

/** The first use of a word on each page becomes a link to the glossary, with its meaning as its title. */
function terms(md, sourceOf, glossary) {
  const known = glossary
    .map((entry) => ({ ...entry, word: entry.term.replace(/ \(.*/, '') }))
    .filter(({ word }) => !AMBIGUOUS.has(word))
    .map((entry) => ({ ...entry, pattern: new RegExp(`(?<![\\w-])${entry.word}s?(?![\\w-])`, 'i') }));
  md.core.ruler.push('glossary', ({ tokens, env, Token }) => {
    const source = sourceOf(env);
    if (!source || source.startsWith('site/') || source === 'docs/glossary.md') return;
    const left = new Set(known);
    tokens.forEach(({ children }, at) => {
      if (!children || tokens[at - 1]?.type === 'heading_open') return;
      let depth = 0;
      for (let k = 0; k < children.length; k++) {
        const token = children[k];
        if (token.type === 'link_open') depth++;
        if (token.type === 'link_close') depth--;
        if (token.type !== 'text' || depth > 0) continue;
        for (const entry of left) {
          const found = entry.pattern.exec(token.content);
          if (!found) continue;
          left.delete(entry);
          const piece = (type, content, nesting, attrs = null) =>
            Object.assign(new Token(type, type === 'text' ? '' : 'a', nesting), { content, attrs });
          const glossaryPage = posix.relative(posix.dirname(addressOf(source)), 'docs/glossary.html');
          children.splice(
            k,
            1,
            piece('text', token.content.slice(0, found.index), 0),
            piece('link_open', '', 1, [
              ['href', `${glossaryPage}#${slug(entry.term)}`],
              ['class', 'term'],
              ['title', entry.meaning],
            ]),
            piece('text', found[0], 0),
            piece('link_close', '', -1),
            piece('text', token.content.slice(found.index + found[0].length), 0),
          );
          break;
        }
      }
    });
  });
}
