// Every link of the built site: the file is there, the place in it too; nothing is fetched from elsewhere to show a page.
import { existsSync, readFileSync, statSync } from 'node:fs';
import { join, posix } from 'node:path';
import { filesIn } from './anywhere.mjs';

const plain = (text) => text.replaceAll('&amp;', '&').replaceAll('&quot;', '"').replaceAll('&#39;', "'");

/** What wants following: `page: link, why not`. */
export function deadLinks(site) {
  const pages = filesIn(site, /\.html$/).filter((path) => !path.startsWith('app/') && path !== '404.html');
  const places = new Map();
  const placesOf = (page) => {
    if (!places.has(page)) {
      const text = readFileSync(join(site, page), 'utf8');
      places.set(page, new Set([...text.matchAll(/\s(?:id|name)="([^"]+)"/g)].map(([, id]) => plain(id))));
    }
    return places.get(page);
  };
  const dead = [];
  let links = 0;
  for (const page of pages) {
    const text = readFileSync(join(site, page), 'utf8').replace(/<script(?![^>]*\bsrc=)[^>]*>[^]*?<\/script>/g, '');
    for (const [, tag, attributes] of text.matchAll(/<(a|link|script|img|iframe|source)\s([^>]*)>/g)) {
      const address = /(?:^|\s)(?:href|src)="([^"]*)"/.exec(attributes)?.[1];
      if (address === undefined || address === '' || /^(data|mailto|blob):/.test(address)) continue;
      links++;
      if (/^(https?:)?\/\//.test(address)) {
        if (tag !== 'a') dead.push(`${page}: ${address} is fetched from elsewhere`);
        continue;
      }
      const [path, hash = ''] = plain(address).split('#');
      if (address.startsWith('/')) {
        dead.push(`${page}: ${address} works from one folder only`);
        continue;
      }
      let file = path.split('?')[0] === '' ? page : posix.join(posix.dirname(page), decodeURI(path.split('?')[0]));
      if (existsSync(join(site, file)) && statSync(join(site, file)).isDirectory())
        file = posix.join(file, 'index.html');
      if (!existsSync(join(site, file))) dead.push(`${page}: ${address}, there is no ${file}`);
      else if (
        hash !== '' &&
        file.endsWith('.html') &&
        !file.startsWith('app/') &&
        !placesOf(file).has(decodeURIComponent(hash))
      )
        dead.push(`${page}: ${address}, ${file} has no such place`);
    }
  }
  return { pages: pages.length, links, dead };
}
