// Which of the repository's documents are pages of the site, where each stands in the list at the left, and under what address.
// The sources stay where they are; nothing is written twice.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** Pages whose address is another than their place in the repository. */
const MOVED = {
  'site/index.md': 'index.md',
  'site/gallery.md': 'gallery.md',
  'site/lessons.md': 'lessons/index.md',
  'README.md': 'start.md',
  'ARCHITECTURE.md': 'architecture.md',
  'CONTRIBUTING.md': 'contributing.md',
  'CHANGELOG.md': 'changelog.md',
  'docs/decisions/README.md': 'docs/decisions/index.md',
};

const listed = (folder) =>
  readdirSync(join(root, folder))
    .filter((name) => name.endsWith('.md') && name !== 'README.md')
    .sort()
    .map((name) => `${folder}/${name}`);
const docs = (names) => names.split(' ').map((name) => `docs/${name}.md`);

/** The list at the left. Every document under docs/ stands in it; `checkPages` says where one does not. */
const GROUPS = [
  {
    title: 'The page',
    pages: ['README.md', ...docs('page riding gaits control expressions csv-format own-systems'), 'docs/glossary.md'],
  },
  { title: 'Lessons', pages: ['site/lessons.md', ...listed('lessons'), 'docs/lessons.md'] },
  {
    title: 'Systems',
    pages: docs(
      'ripstik ripstik-rider bicycle casterboard-robot chaplygin-sleigh rolling-wheel wheel-pendulum cart-pendulum caster-rotation stiff-decay',
    ),
  },
  { title: 'Other doors', pages: docs('package python sweeps exchange embedding') },
  { title: 'What is known', pages: ['site/gallery.md', ...docs('cases performance robustness')] },
  {
    title: 'Inside',
    pages: [
      'ARCHITECTURE.md',
      ...docs('adding-a-feature adding-a-system dependencies'),
      'CONTRIBUTING.md',
      'CHANGELOG.md',
      'docs/decisions/README.md',
    ],
  },
];
/** The list on the pages of the decisions. */
const DECISIONS = { title: 'Decisions', pages: ['docs/decisions/README.md', ...listed('docs/decisions')] };

/** Titles in the list where the page's own is too long for it. */
const SHORT = {
  'README.md': 'First steps',
  'site/lessons.md': 'All lessons',
  'docs/lessons.md': 'Writing a lesson',
  'docs/control.md': 'Control',
  'docs/csv-format.md': 'CSV files',
  'docs/decisions/README.md': 'Decisions',
};

export const pages = new Set(['site/index.md', ...[...GROUPS, DECISIONS].flatMap((group) => group.pages)]);

/** @throws Error where a page is missing, or a document stands in no list */
export function checkPages() {
  const missing = [...pages].filter((page) => !existsSync(join(root, page)));
  if (missing.length > 0) throw new Error(`site/.vitepress/pages.mjs lists what is not there: ${missing.join(', ')}`);
  const unlisted = listed('docs').filter((page) => !pages.has(page));
  if (unlisted.length > 0) throw new Error(`site/.vitepress/pages.mjs lists no place for ${unlisted.join(', ')}`);
}

/** What VitePress, which takes every Markdown file it finds, is told to leave out: whole folders, and files beside the pages. */
export function noPages() {
  const folders = new Set([...pages].map((page) => dirname(page)));
  const inside = (folder) =>
    readdirSync(join(root, folder), { withFileTypes: true }).flatMap((entry) => {
      const path = folder === '.' ? entry.name : `${folder}/${entry.name}`;
      if (!entry.isDirectory()) return path.endsWith('.md') && !pages.has(path) ? [path] : [];
      return folders.has(path) ? inside(path) : [`${path}/**`];
    });
  return inside('.');
}

const titleOf = (page) => /^# (.+)$/m.exec(readFileSync(join(root, page), 'utf8'))?.[1].replaceAll('`', '') ?? page;

/** @param page its path in the repository; the result is its path on the site, with `.md` */
export const addressOf = (page) => MOVED[page] ?? page;

export const rewrites = MOVED;

const groupOf = ({ title, pages: own }) => ({
  text: title,
  items: own.map((page) => ({
    text: SHORT[page] ?? titleOf(page),
    link: `/${addressOf(page)
      .replace(/index\.md$/, '')
      .replace(/\.md$/, '.html')}`,
  })),
});

export const sidebar = () => ({
  '/': GROUPS.map(groupOf),
  '/docs/decisions/': [
    groupOf(DECISIONS),
    { text: 'Documents', items: [{ text: SHORT['README.md'], link: '/start.html' }] },
  ],
});
