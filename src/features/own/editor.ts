/** The text editor: CodeMirror with the words of the language, in the page's own colours. */
import {
  autocompletion,
  completionKeymap,
  type CompletionContext,
  type CompletionResult,
} from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { lintGutter, setDiagnostics, type Diagnostic } from '@codemirror/lint';
import { EditorState, type Extension } from '@codemirror/state';
import { drawSelection, EditorView, highlightActiveLine, hoverTooltip, keymap, lineNumbers } from '@codemirror/view';
import { tags } from '@lezer/highlight';
import { vocabulary, type DescriptionError } from '../../core/description/index.ts';
import { words } from './words.ts';

const statements = new Map(vocabulary.statements.map((statement) => [statement.word, statement]));
const functions = new Set(vocabulary.functions);
const constants = new Set(vocabulary.constants);
const following = new Set(vocabulary.statements.flatMap((statement) => statement.words));

/** Colours: comments, texts, numbers, units, first words of lines, words that may follow, functions, constants. */
const language = StreamLanguage.define<{ first: boolean }>({
  name: 'description',
  startState: () => ({ first: true }),
  token(stream, state) {
    if (stream.sol()) state.first = true;
    if (stream.eatSpace()) return null;
    if (stream.match(/^#.*/)) return 'comment';
    if (stream.match(/^"[^"]*"?/)) return 'string';
    if (stream.match(/^\[[^\]]*\]/)) return 'unit';
    if (stream.match(/^\d+\.?\d*(?:[eE][-+]?\d+)?|^\.\d+/)) return 'number';
    if (stream.match(/^\p{L}[\p{L}\p{N}_]*'*/u)) {
      const word = stream.current();
      const first = state.first;
      state.first = false;
      if (first && statements.has(word)) return 'keyword';
      if (functions.has(word)) return 'variableName.function';
      if (constants.has(word)) return 'atom';
      return following.has(word) ? 'modifier' : 'variableName';
    }
    state.first = false;
    stream.next();
    return null;
  },
});

const colours = HighlightStyle.define([
  { tag: tags.keyword, color: 'var(--accent)', fontWeight: '600' },
  { tag: tags.comment, color: 'var(--muted)', fontStyle: 'italic' },
  { tag: tags.string, color: 'var(--first)' },
  { tag: [tags.number, tags.atom, tags.unit], color: 'var(--second)' },
  { tag: [tags.modifier, tags.function(tags.variableName)], color: 'var(--accent)' },
]);

/** In the tokens of the page, which pass into the editor's own tree: light and dark follow by themselves. */
const theme = EditorView.theme({
  '&': { height: '100%', backgroundColor: 'var(--surface)', color: 'var(--text)', fontSize: '13px' },
  '&.cm-focused': { outline: '2px solid var(--accent)', outlineOffset: '-2px' },
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--text)' },
  '.cm-cursor': { borderLeftColor: 'var(--text)' },
  '.cm-gutters': { backgroundColor: 'var(--sunken)', color: 'var(--muted)', borderRight: '1px solid var(--line)' },
  '.cm-activeLine': { backgroundColor: 'color-mix(in srgb, var(--accent) 7%, transparent)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    backgroundColor: 'var(--accent-soft)',
  },
  '.cm-tooltip': { backgroundColor: 'var(--raised)', color: 'var(--text)', border: '1px solid var(--line)' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    backgroundColor: 'var(--accent)',
    color: 'var(--on-accent)',
  },
  '.cm-completionDetail': { color: 'inherit', opacity: '0.75' },
});

/** Names that the text defines, by what they are; asked for when a list is shown. */
export type Names = () => ReadonlyMap<string, { kind: string; line: number }>;

function completion(names: Names) {
  return (context: CompletionContext): CompletionResult | null => {
    const word = context.matchBefore(/[\p{L}_][\p{L}\p{N}_]*/u);
    if (!word && !context.explicit) return null;
    const from = word?.from ?? context.pos;
    const line = context.state.doc.lineAt(from);
    const before = line.text.slice(0, from - line.from);
    const defined = [...names()].map(([label, { kind }]) => ({ label, type: 'variable', detail: kind }));
    if (before.trim() === '')
      return {
        from,
        options: [
          ...vocabulary.statements.map(({ word: label, example }) => ({ label, type: 'keyword', detail: example })),
          ...defined,
        ],
      };
    const statement = statements.get(/^\s*(\S+)/.exec(before)?.[1] ?? '');
    return {
      from,
      options: [
        ...(statement?.words ?? []).map((label) => ({ label, type: 'keyword' })),
        ...defined,
        ...vocabulary.functions.map((label) => ({
          label,
          type: 'function',
          detail: vocabulary.vectorFunctions.get(label) ?? '',
        })),
        ...vocabulary.constants.filter((label) => !names().has(label)).map((label) => ({ label, type: 'constant' })),
      ],
    };
  };
}

/** What the word under the pointer is: of a statement how it is written, of a name where it is defined. */
const meaning = (names: Names) =>
  hoverTooltip((view, at) => {
    const line = view.state.doc.lineAt(at);
    const found = [...line.text.matchAll(/[\p{L}_][\p{L}\p{N}_]*/gu)].find(
      ({ index, 0: word }) => line.from + index <= at && at <= line.from + index + word.length,
    );
    if (!found) return null;
    const [word] = found;
    const known = names().get(word) ?? names().get(word.replace(/_dot$/, ''));
    const first = line.text.slice(0, found.index).trim() === '';
    const said =
      (first ? statements.get(word)?.example : undefined) ??
      (known ? words.defined(known.kind, known.line) : vocabulary.vectorFunctions.get(word));
    if (said === undefined) return null;
    const pos = line.from + found.index;
    return {
      pos,
      end: pos + word.length,
      create: () => {
        const dom = document.createElement('div');
        dom.textContent = said;
        dom.style.padding = '2px 8px';
        return { dom };
      },
    };
  });

export interface TextEditor {
  readonly text: string;
  /** Puts another text in place of all; Ctrl Z brings the old one back. */
  replace(text: string): void;
  /** Marks what is wrong. */
  mark(faults: readonly DescriptionError[]): void;
  goTo(line: number): void;
  destroy(): void;
}

/** @param changed told after every change of the text by a person */
export function createEditor(
  parent: HTMLElement,
  text: string,
  names: Names,
  changed: (text: string) => void,
): TextEditor {
  const extensions: Extension[] = [
    lineNumbers(),
    history(),
    drawSelection(),
    highlightActiveLine(),
    language,
    syntaxHighlighting(colours),
    theme,
    lintGutter(),
    meaning(names),
    autocompletion({ override: [completion(names)], icons: false }),
    keymap.of([...completionKeymap, ...historyKeymap, ...defaultKeymap]),
    EditorView.contentAttributes.of({
      'aria-label': words.editor,
      'data-testid': 'own-text',
      tabindex: '0',
      spellcheck: 'false',
    }),
    EditorView.updateListener.of((update) => {
      if (update.docChanged) changed(update.state.doc.toString());
    }),
  ];
  // In a tree of its own CodeMirror's style sheets are objects, which the page's policy lets in; as elements it would not.
  const root = parent.shadowRoot ?? parent.attachShadow({ mode: 'open' });
  const view = new EditorView({ state: EditorState.create({ doc: text, extensions }), parent: root, root });
  // The page's own keys (space plays, Ctrl Z) are the editor's here.
  const ours = (event: Event): void => event.stopPropagation();
  parent.addEventListener('keydown', ours);
  // What is said of faults takes its room from the text: the line that is typed stays in sight.
  const sized = new ResizeObserver(() => {
    if (view.hasFocus) view.dispatch({ effects: EditorView.scrollIntoView(view.state.selection.main.head) });
  });
  sized.observe(parent);
  const place = ({ line, column = 1, length = 1 }: DescriptionError): { from: number; to: number } => {
    const { doc } = view.state;
    if (line < 1 || line > doc.lines) return { from: 0, to: Math.min(1, doc.length) };
    const at = doc.line(line);
    const from = Math.min(at.from + Math.max(column - 1, 0), at.to);
    return { from, to: Math.min(from + Math.max(length, 1), at.to) };
  };
  return {
    get text() {
      return view.state.doc.toString();
    },
    replace: (next) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: next } }),
    mark(faults) {
      const diagnostics = faults
        .map((fault): Diagnostic => ({ ...place(fault), severity: 'error', message: fault.reason }))
        .sort((a, b) => a.from - b.from);
      view.dispatch(setDiagnostics(view.state, diagnostics));
    },
    goTo(line) {
      const at = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
      view.dispatch({ selection: { anchor: at.from }, scrollIntoView: true });
      view.focus();
    },
    destroy() {
      parent.removeEventListener('keydown', ours);
      sized.disconnect();
      view.destroy();
    },
  };
}
