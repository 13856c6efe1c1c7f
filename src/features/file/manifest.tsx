import './file.css';
import type { Feature } from '../../ui/feature.ts';
import { DropOverlay } from './dropOverlay.tsx';
import { FileNotes, FilePanel } from './filePanel.tsx';
import { OpenButtons } from './openButtons.tsx';
import { StepDialog } from './stepDialog.tsx';
import { words } from './words.ts';

export const file: Feature = {
  id: 'file',
  order: 90,
  topEnd: OpenButtons,
  tab: {
    title: words.title,
    Body: FilePanel,
    // an opened file is what one wants to read about
    wanted: ({ state }) => state.motion.value?.source === 'file',
  },
  notes: FileNotes,
  dialog: () => (
    <>
      <StepDialog />
      <DropOverlay />
    </>
  ),
};
