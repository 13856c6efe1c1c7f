import type { Feature } from '../../ui/feature.ts';
import { TakeTour, Welcome } from './welcome.tsx';

export const welcome: Feature = { id: 'welcome', order: 130, card: Welcome, help: TakeTour };
