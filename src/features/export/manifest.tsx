import type { Feature } from '../../ui/feature.ts';
import { ExportDoor } from './exportDoor.tsx';
import { ExportMenu } from './exportMenu.tsx';

export const exporting: Feature = { id: 'export', order: 100, topEnd: ExportMenu, dialog: ExportDoor };
