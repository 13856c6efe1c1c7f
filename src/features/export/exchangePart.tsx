/** The system for MuJoCo, SymPy or C: written in a worker, saved, and what the format cannot say told beside it. */
import { useRef, useState } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import type { ExchangeFormat } from '../../core/exchange/index.ts';
import { checkScenario } from '../../core/scenario/schema.ts';
import { ScenarioError } from '../../core/scenario/types.ts';
import { systemMetas } from '../../core/systems/registry.ts';
import { useUi } from '../../ui/context.ts';
import { words } from './words.ts';

const { exchange: text } = words;

interface Told {
  failed: boolean;
  lines: readonly string[];
}

export function ExchangePart() {
  const { state, mechanics } = useUi().app;
  const [told, setTold] = useState<Told | null>(null);
  const [busy, setBusy] = useState(false);
  const latest = useRef(0);
  const save = async (format: ExchangeFormat): Promise<void> => {
    const turn = ++latest.current;
    let scenario;
    try {
      scenario = checkScenario(state.draft.peek(), systemMetas);
    } catch (error) {
      if (!(error instanceof ScenarioError)) throw error;
      return setTold({ failed: true, lines: [text.refused(error.message)] });
    }
    setBusy(true);
    const answer = await mechanics.export(scenario, format);
    if (turn !== latest.current || !answer) return;
    setBusy(false);
    if (!answer.ok) return setTold({ failed: true, lines: [text.refused(answer.message)] });
    const { name, text: content, notes } = answer.value;
    download(name, [content], 'text/plain');
    setTold({ failed: false, lines: [text.saved(name), ...notes] });
  };
  return (
    <section class="data" aria-label={text.title}>
      <h3>{text.title}</h3>
      <div class="pair">
        {(Object.keys(text.formats) as ExchangeFormat[]).map((format) => (
          <button
            key={format}
            type="button"
            data-testid={`save-${format}`}
            disabled={busy}
            onClick={() => void save(format)}
          >
            {text.formats[format]}
          </button>
        ))}
      </div>
      <p class="hint">{text.about}</p>
      <div role="status" data-testid="exchange-told" data-failed={told?.failed ?? false}>
        {busy ? <p class="hint">{text.working}</p> : told?.lines.map((line) => <p key={line}>{line}</p>)}
      </div>
    </section>
  );
}
