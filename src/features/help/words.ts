import { firstWords } from './firstWords.ts';

/** Words of the help. */
export const words = {
  ...firstWords,
  back: 'All documents',
  version: (version: string) => `RipStik Lab ${version}`,
  aboutParts: [
    'A laboratory for the RipStik, a board on two casters that gathers speed without a push and balances on two wheels. Change anything: the motion follows.',
    'It grew out of a report: “A-1: Modelling and Control of a Ripstik”, the final report of the course MTHE 493, 2017. Where the page says “the report”, it means this one. Its systems are here, with those of a few papers, which their cases name.',
    'Everything is computed in this browser. Nothing you do is sent anywhere; your work is kept in this browser only.',
  ],
  licence: 'It is free software under the MIT licence; Licences names the packages that it carries.',
  site: 'Documents, lessons, gallery and reference',
  noSite:
    'The documents are here, under Documents. As a site with search, with lessons, gallery and reference, the repository builds them by “npm run site”.',
  own: 'RipStik Lab is free software under the MIT licence. It carries the following packages:',
  texts: 'The text of every licence',
} as const;
