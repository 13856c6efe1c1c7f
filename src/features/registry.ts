/** All features of the page, one line each. Where a feature stands among the others is its manifest's `order`. */
export { experiment } from './experiment/manifest.tsx';
export { gallery } from './gallery/manifest.tsx';
export { now } from './now/manifest.tsx';
export { plots } from './plots/manifest.tsx';
export { equations } from './equations/manifest.tsx';
export { analysis } from './analysis/manifest.tsx';
export { gaits } from './gaits/manifest.tsx';
export { methods } from './methods/manifest.tsx';
export { trust } from './trust/manifest.tsx';
export { compare } from './compare/manifest.tsx';
export { file } from './file/manifest.tsx';
export { importing } from './import/manifest.tsx';
export { exporting } from './export/manifest.tsx';
export { share } from './share/manifest.tsx';
export { push } from './push/manifest.tsx';
export { help } from './help/manifest.tsx';
export { welcome } from './welcome/manifest.tsx';
