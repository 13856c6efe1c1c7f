/** The results of a sweep: a picture of all runs, each of which opens on the stage, and their table. */
import { useSignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { systemMetas } from '../../app/store.ts';
import { settled } from '../../core/scenario/own.ts';
import { scenarioOfRow, variedOf, type StudyResults } from '../../core/sweep/studyResults.ts';
import { useUi } from '../../ui/context.ts';
import { formatCount } from '../../ui/kit/format.ts';
import { quantitiesOf } from './quantities.ts';
import { StudyPicture } from './studyPicture.tsx';
import { StudyTable } from './studyTable.tsx';
import './study.css';
import { words } from './words.ts';

/** A basin of recovery that comes with the page. */
const EXAMPLE = 'studies/basin.parquet';

export function StudyTool() {
  const { app } = useUi();
  const results = app.state.study.value;
  return (
    <div class="study scroll" data-testid="study">
      {results ? <Results key={results} results={results} /> : <Nothing />}
    </div>
  );
}

function Nothing() {
  const { app } = useUi();
  const open = async (): Promise<void> => {
    const { openFileAddress } = await import('../../app/files/fileAddress.ts');
    await openFileAddress(app, EXAMPLE);
  };
  return (
    <div class="pad">
      <p class="hint">{words.none}</p>
      <button type="button" data-testid="study-example" onClick={() => void open()}>
        {words.example}
      </button>
    </div>
  );
}

function Results({ results }: { results: StudyResults }) {
  const { app } = useUi();
  const { degrees } = app.state.plots.value;
  const quantities = useMemo(() => quantitiesOf(results, systemMetas, degrees), [results, degrees]);
  const all = useMemo(() => Array.from({ length: results.rows }, (_, row) => row), [results]);
  const rows = useSignal<readonly number[]>(all);
  const open = results.study
    ? (row: number): void => {
        const scenario = scenarioOfRow(results, row)!;
        const title = words.run(results.title, quantities.get('index')!.cell(row));
        app.actions.loadScenario(settled(scenario), title);
      }
    : null;
  const facts = [
    words.rows(formatCount(rows.value.length), formatCount(results.rows)),
    ...(results.shard === '1/1' ? [] : [words.shard(results.shard)]),
    ...(results.engine === '' ? [] : [words.engine(results.engine)]),
  ];
  return (
    <>
      <p class="hint pad" data-testid="study-facts">
        <strong>{results.title}</strong>: {facts.join(', ')}
      </p>
      {!open && <p class="hint pad">{words.noStudy}</p>}
      <StudyPicture
        title={results.title}
        quantities={quantities}
        varied={variedOf(results)}
        all={all}
        onRows={(next) => {
          rows.value = next;
        }}
        onOpen={open}
      />
      <StudyTable title={results.title} quantities={quantities} rows={rows.value} onOpen={open} />
    </>
  );
}
