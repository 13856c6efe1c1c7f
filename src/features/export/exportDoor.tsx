import { useUi } from '../../ui/context.ts';
import { later } from '../../ui/kit/later.tsx';

const Loaded = later(async () => (await import('./exportDialog.tsx')).ExportDialog);

/** The export dialog, loaded when it is first opened. */
export function ExportDoor() {
  return useUi().app.state.dialog.value === 'export' ? <Loaded /> : null;
}
