import './help.css';
import type { Feature } from '../../ui/feature.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords as words } from './firstWords.ts';

export const help: Feature = {
  id: 'help',
  order: 140,
  helpPages: [
    { id: 'terms', title: words.terms, Body: later(async () => (await import('./terms.tsx')).Terms) },
    { id: 'documents', title: words.documents, Body: later(async () => (await import('./documents.tsx')).Documents) },
    { id: 'about', title: words.about, Body: later(async () => (await import('./about.tsx')).About) },
    { id: 'licences', title: words.licences, Body: later(async () => (await import('./about.tsx')).Licences) },
  ],
};
