import './share.css';
import type { Feature } from '../../ui/feature.ts';
import { ShareButton } from './share.tsx';

export const share: Feature = { id: 'share', order: 110, topEnd: ShareButton };
