import './methods.css';
import { useUi } from '../../ui/context.ts';
import { Methods } from './methodsView.tsx';
import { plotComparison, saveOutcomes, savePicture } from './methodCurves.ts';

export function MethodsTool() {
  const { app } = useUi();
  return (
    <Methods
      comparison={app.comparison}
      plot={(...args) => plotComparison(app, ...args)}
      saveTable={saveOutcomes}
      savePicture={savePicture}
    />
  );
}
