import type { Feature } from '../../ui/feature.ts';
import { TakeTour, Welcome } from './welcome.tsx';

export const welcome: Feature = { id: 'welcome', card: Welcome, help: TakeTour };
