import './methods.css';
import { useUi } from '../../ui/context.ts';
import { Methods } from './methodsView.tsx';
import { saveOutcomes } from './outcomesCsv.ts';

export function MethodsTool() {
  const { app } = useUi();
  return <Methods comparison={app.comparison} saveTable={saveOutcomes} />;
}
