/** One's own system: a text, read as it is typed; once it is right it is in the panel and runs. */
import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { download } from '../../app/files/download.ts';
import { ownCase } from '../../app/state/cases.ts';
import { readSystem, type DescriptionError } from '../../core/description/index.ts';
import { templates } from '../../core/description/templates.ts';
import { isOwn } from '../../core/scenario/own.ts';
import { ScenarioError } from '../../core/scenario/types.ts';
import { learnSystem } from '../../core/systems/registry.ts';
import { edit, useUi, type Ui } from '../../ui/context.ts';
import { FileButton, textOfFile } from '../../ui/kit/fileButton.tsx';
import { carriedOver } from './adopt.ts';
import { createEditor, type Names, type TextEditor } from './editor.ts';
import { Formulas } from './formulas.tsx';
import './own.css';
import { words } from './words.ts';

/** From the last key to reading, ms: the text is read in a few. */
const PAUSE_MS = 250;

type Standing =
  | { kind: 'untouched'; title: string; id: string | null }
  | { kind: 'fine'; title: string; id: string }
  | { kind: 'empty' }
  | { kind: 'faults'; faults: readonly DescriptionError[] }
  | { kind: 'refused'; reason: string };

/** What stands in the editor first: the system in the panel, as it was typed or as its template. */
async function firstText(ui: Ui): Promise<{ text: string; title: string; id: string | null }> {
  const { meta } = ui.system.peek() ?? {};
  if (meta?.description !== undefined) return { text: meta.description, title: meta.title, id: meta.id };
  const template = templates.find(({ id }) => id === meta?.id) ?? templates[0]!;
  return { text: (await template.load()).default, title: template.title, id: null };
}

export function OwnTool() {
  const ui = useUi();
  const place = useRef<HTMLDivElement>(null);
  const editor = useRef<TextEditor | null>(null);
  const names = useRef<ReturnType<Names>>(new Map());
  const standing = useSignal<Standing>({ kind: 'empty' });
  const timer = useRef<ReturnType<typeof setTimeout>>(undefined);

  const read = async (text: string): Promise<void> => {
    const reading = readSystem(text);
    names.current = reading.names;
    editor.current?.mark(reading.faults);
    if (text.trim() === '') standing.value = { kind: 'empty' };
    else if (!reading.view) standing.value = { kind: 'faults', faults: reading.faults };
    else
      try {
        const { meta } = await learnSystem(text, reading);
        // Another key was pressed meanwhile.
        if (editor.current?.text !== text) return;
        standing.value = { kind: 'fine', title: meta.title, id: meta.id };
        const draft = ui.app.state.draft.peek();
        if (draft.system === meta.id) return;
        const next = carriedOver(draft, meta);
        if (isOwn(draft.system)) edit(ui, words.label, () => next);
        else ui.app.actions.openScenario(ownCase(meta.title, next), next);
      } catch (error) {
        if (!(error instanceof ScenarioError)) throw error;
        standing.value = { kind: 'refused', reason: error.message };
      }
  };
  const soon = (text: string): void => {
    clearTimeout(timer.current);
    timer.current = setTimeout(() => void read(text), PAUSE_MS);
  };

  useEffect(() => {
    let gone = false;
    void firstText(ui).then(({ text, title, id }) => {
      if (gone) return;
      begun.value = ui.system.peek()?.meta.id ?? null;
      names.current = readSystem(text).names;
      editor.current = createEditor(place.current!, text, () => names.current, soon);
      standing.value = { kind: 'untouched', title, id };
    });
    return () => {
      gone = true;
      clearTimeout(timer.current);
      editor.current?.destroy();
      editor.current = null;
    };
  }, []);

  const put = (text: string): void => {
    editor.current?.replace(text);
    clearTimeout(timer.current);
    void read(text);
  };
  const now = standing.value;
  // What was right last stays to be read while a line is not.
  const shown = ui.system.value?.meta;
  const last = useRef<string | null>(null);
  const begun = useSignal<string | null>(null);
  if (now.kind === 'fine' || now.kind === 'untouched') last.current = now.id;
  const id = last.current;
  const editing = id ?? begun.value;
  const title = now.kind === 'fine' || now.kind === 'untouched' ? now.title : '';
  return (
    <div class="scroll own" data-testid="own">
      <p class="hint">{words.intro}</p>
      <div class="own-bar">
        <label>
          {words.begin}{' '}
          <select
            data-testid="own-template"
            value=""
            onChange={(event) => {
              const chosen = templates.find(({ id }) => id === event.currentTarget.value);
              event.currentTarget.value = '';
              void chosen?.load().then((module) => put(module.default));
            }}
          >
            <option value="" disabled>
              {words.choose}
            </option>
            {templates.map((template) => (
              <option key={template.id} value={template.id}>
                {template.title}
              </option>
            ))}
          </select>
        </label>
        <FileButton
          label={words.open}
          accept=".txt"
          testId="own-open"
          onFile={(file) => void textOfFile(file).then(put)}
        />
        <button
          type="button"
          data-testid="own-save"
          onClick={() => download(words.file(title), [editor.current?.text ?? ''], 'text/plain')}
        >
          {words.save}
        </button>
      </div>
      {shown && shown.id !== editing && (
        <button
          type="button"
          data-testid="own-duplicate"
          onClick={() => {
            void firstText(ui).then((first) => put(first.text));
          }}
        >
          {words.duplicate(shown.title)}
        </button>
      )}
      <div class="own-editor" ref={place} />
      <div class="own-state" role="status" data-testid="own-state" data-state={now.kind}>
        <State now={now} onGo={(line) => editor.current?.goTo(line)} />
      </div>
      {id !== null && (
        <details class="own-equations" open>
          <summary>{words.equations}</summary>
          <Formulas id={id} />
        </details>
      )}
    </div>
  );
}

function State({ now, onGo }: { now: Standing; onGo(line: number): void }) {
  switch (now.kind) {
    case 'empty':
      return <p class="hint">{words.empty}</p>;
    case 'untouched':
      return <p class="hint">{words.untouched(now.title)}</p>;
    case 'fine':
      return <p>{words.fine(now.title)}</p>;
    case 'refused':
      return <p class="error">{words.refused(now.reason)}</p>;
    case 'faults':
      return (
        <>
          <p>{words.faults(now.faults.length)}</p>
          <ul>
            {now.faults.map(({ line, column, reason }) => (
              <li key={`${line} ${column}`}>
                <button type="button" onClick={() => onGo(line)}>
                  {words.fault(line, reason)}
                </button>
              </li>
            ))}
          </ul>
        </>
      );
  }
}
