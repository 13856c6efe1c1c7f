import type { Feature } from '../../ui/feature.ts';
import { ExportDoor } from './exportDoor.tsx';
import { ExportMenu } from './exportMenu.tsx';
import { firstWords } from './firstWords.ts';

export const exporting: Feature = {
  id: 'export',
  order: 100,
  topEnd: ExportMenu,
  dialog: ExportDoor,
  commands: [
    {
      id: 'export-csv',
      label: firstWords.csv,
      enabled: ({ state }) => state.motion.value !== null,
      perform: ({ actions }) => actions.exportCsv(),
    },
    { id: 'save-scenario', label: firstWords.scenario, perform: ({ actions }) => actions.saveScenario() },
    { id: 'export', label: firstWords.more, perform: ({ actions }) => actions.openDialog('export') },
  ],
};
