import { download } from '../../app/files/download.ts';
import { AnalysisView } from './analysisView.tsx';
import { useUi } from '../../ui/context.ts';
import { plotLocus } from './locusDrawing.ts';

export function AnalysisTool() {
  const { app } = useUi();
  return (
    <AnalysisView
      plot={(...args) => plotLocus(app, ...args)}
      save={(name, content, type) => download(name, [content], type)}
    />
  );
}
