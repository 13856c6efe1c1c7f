/** `licences.txt` beside the built page: the licence of every package whose code can be in it, as its authors wrote it. */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

interface LockFile {
  packages: Record<string, { version?: string; license?: string; dev?: boolean; optional?: boolean; peer?: boolean }>;
}

/** @param root the repository */
export function licencesOf(root: string): string {
  const { packages } = JSON.parse(readFileSync(join(root, 'package-lock.json'), 'utf8')) as LockFile;
  const own = readFileSync(join(root, 'LICENSE'), 'utf8').trim();
  const parts = Object.entries(packages)
    .filter(([place, { dev, optional, peer }]) => place !== '' && !dev && !optional && !peer)
    .map(([place, { version, license }]) => {
      const folder = join(root, place);
      const files = readdirSync(folder).filter((file) => /^(licen[cs]e|copying|notice)/i.test(file));
      const texts = files.map((file) => readFileSync(join(folder, file), 'utf8').trim());
      const name = place.replace(/^.*node_modules\//, '');
      return [`${name} ${version ?? ''}, ${license ?? ''}`, ...texts].join('\n\n');
    });
  return ['RipStik Lab', own, ...parts].join(`\n\n${'-'.repeat(80)}\n\n`).concat('\n');
}

export const licences = () => ({
  name: 'licences',
  apply: 'build' as const,
  generateBundle(this: { emitFile(file: { type: 'asset'; fileName: string; source: string }): string }) {
    this.emitFile({ type: 'asset', fileName: 'licences.txt', source: licencesOf(join(import.meta.dirname, '..')) });
  },
});
