/** In the place of the scene, where the file is data: where its numbers are. */
import './open.css';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

export function DataDoor() {
  const { app, tools } = useUi();
  if (app.state.motion.value?.source !== 'file') return null;
  return (
    <div class="import-doors">
      {tools.some(({ id }) => id === 'plots') && (
        <button type="button" class="primary" data-testid="data-plots" onClick={() => app.actions.set('tool', 'plots')}>
          {words.dataButton}
        </button>
      )}
      <button type="button" data-testid="data-how" onClick={() => app.actions.set('tool', 'import')}>
        {words.how}
      </button>
    </div>
  );
}
