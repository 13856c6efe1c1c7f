import './caseMenu.css';
import type { Feature } from '../../ui/feature.ts';
import { CaseMenu } from './caseMenu.tsx';

export const gallery: Feature = { id: 'gallery', order: 20, topStart: CaseMenu };
