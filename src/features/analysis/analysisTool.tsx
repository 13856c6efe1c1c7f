import { download } from '../../app/files/download.ts';
import { AnalysisView } from './analysisView.tsx';

export function AnalysisTool() {
  return <AnalysisView save={(name, content, type) => download(name, [content], type)} />;
}
