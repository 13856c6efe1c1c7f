import type { ComponentType } from 'preact';
import type { Feature } from '../../ui/feature.ts';
import { useUi } from '../../ui/context.ts';
import { later } from '../../ui/kit/later.tsx';
import { firstWords } from './firstWords.ts';

const AskDialog = later(async () => (await import('./askDialog.tsx')).AskDialog);
const Questions = later(async () => (await import('./questions.tsx')).StageQuestions);

/** Loaded when the first file is on the stage. */
function withFile(load: () => Promise<ComponentType>): ComponentType {
  const View = later(load);
  return () => (useUi().app.state.motion.value?.source === 'file' ? <View /> : null);
}

export const importing: Feature = {
  id: 'import',
  order: 88,
  document: 'csv-format.md',
  tool: {
    title: firstWords.title,
    icon: 'table',
    size: 'wide',
    // an opened file is what one wants to read about
    wanted: ({ state }) => state.motion.value?.source === 'file',
    Body: later(async () => (await import('./importTool.tsx')).ImportTool),
  },
  caption: () => ((useUi().app.state.motion.value?.imported?.plan.questions.length ?? 0) > 0 ? <Questions /> : null),
  noScene: withFile(async () => (await import('./dataDoor.tsx')).DataDoor),
  notes: withFile(async () => (await import('./fileNotes.tsx')).FileNotes),
  dialog: () => (useUi().app.state.pendingFile.value ? <AskDialog /> : null),
};
