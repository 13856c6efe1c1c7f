import type { Feature } from '../../ui/feature.ts';
import './trust.css';
import { TrustBand } from './trustBand.tsx';
import { TrustStatus } from './trustStatus.tsx';

export const trust: Feature = { id: 'trust', order: 75, runStatus: TrustStatus, timeLine: TrustBand };
