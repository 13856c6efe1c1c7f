import type { Feature } from '../ui/feature.ts';
import { analysis } from './analysis/manifest.tsx';
import { compare } from './compare/manifest.tsx';
import { equations } from './equations/manifest.tsx';
import { experiment } from './experiment/manifest.tsx';
import { exporting } from './export/manifest.tsx';
import { file } from './file/manifest.tsx';
import { gallery } from './gallery/manifest.tsx';
import { methods } from './methods/manifest.tsx';
import { now } from './now/manifest.tsx';
import { plots } from './plots/manifest.tsx';
import { push } from './push/manifest.tsx';
import { share } from './share/manifest.tsx';
import { welcome } from './welcome/manifest.tsx';

/** All there is on the page, in the order in which each slot shows it. */
export const features: readonly Feature[] = [
  experiment,
  gallery,
  now,
  plots,
  equations,
  analysis,
  methods,
  compare,
  file,
  exporting,
  share,
  push,
  welcome,
];
