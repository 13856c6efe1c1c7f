/**
 * A lesson: Markdown in which fenced blocks `live` and `question` are `key: value` lines. docs/lessons.md teaches how to write one.
 * Lessons come from strangers too: everything is bounded, and nothing in one is code or markup.
 */
import { ScenarioError } from '../scenario/types.ts';

const LONGEST = 60_000;
const MOST_BLOCKS = 60;

/** What a question asks the program for. */
export interface Ask {
  kind: 'end' | 'max' | 'min' | 'range' | 'time' | 'growth';
  /** Of a run; of `growth` and `time` empty. */
  column: string;
}

/** A scenario: a built-in case by its id, or JSON as it was written. */
export type Subject = { case: string } | { scenario: Record<string, unknown> };

export interface Vary {
  /** `initial.alpha`, `parameters.casterTrail`. */
  path: [string, string];
  from: number;
  to: number;
}

/** Columns over the time or over another one. */
export interface LessonPlot {
  x: string;
  y: readonly string[];
}

/** `line`: where the block begins in the file. */
export type Block =
  | { kind: 'text'; text: string }
  | { kind: 'live'; line: number; title: string; subject: Subject; vary: Vary | null; plot: LessonPlot | null }
  | {
      kind: 'question';
      line: number;
      text: string;
      unit: string;
      /** Relative. */
      tolerance: number;
      hint: string;
      subject: Subject;
      ask: Ask;
      /** The answer is the number times this. */
      times: number;
    };

export interface Lesson {
  title: string;
  blocks: Block[];
}

/**
 * Reads a lesson.
 *
 * @param text Markdown
 * @throws ScenarioError with the line of what is wrong
 */
export function readLesson(text: string): Lesson {
  if (text.length > LONGEST) throw new ScenarioError('', `a lesson has at most ${LONGEST} characters`);
  const lines = text.replace(/^\ufeff/, '').split(/\r\n|\r|\n/);
  const title = /^# (.+)/.exec(lines.find((line) => line.trim() !== '') ?? '')?.[1];
  if (!title) throw new ScenarioError('line 1', 'a lesson begins with its title: # Why a caster steers');
  const blocks: Block[] = [];
  let prose: string[] = [];
  const flush = (): void => {
    if (prose.some((line) => line.trim() !== '')) blocks.push({ kind: 'text', text: prose.join('\n') });
    prose = [];
  };
  for (let at = 0; at < lines.length; at++) {
    const fence = /^```(live|question)\s*$/.exec(lines[at]!);
    if (!fence) {
      prose.push(lines[at]!);
      continue;
    }
    const end = lines.findIndex((line, k) => k > at && /^```\s*$/.test(line));
    if (end < 0) throw new ScenarioError(`line ${at + 1}`, 'this block has no end: ``` on a line of its own');
    flush();
    const fields = fieldsOf(lines.slice(at + 1, end), at + 2);
    blocks.push(fence[1] === 'live' ? liveOf(fields, at + 1) : questionOf(fields, at + 1));
    if (blocks.length > MOST_BLOCKS)
      throw new ScenarioError(`line ${at + 1}`, `a lesson has at most ${MOST_BLOCKS} parts`);
    at = end;
  }
  flush();
  return { title, blocks };
}

type Fields = ReadonlyMap<string, { value: string; line: number }>;

const KEYS = ['title', 'case', 'scenario', 'vary', 'plot', 'ask', 'unit', 'tolerance', 'hint', 'answer', 'times'];

function fieldsOf(lines: readonly string[], from: number): Fields {
  const fields = new Map<string, { value: string; line: number }>();
  lines.forEach((content, k) => {
    if (content.trim() === '') return;
    const [, key, value] = /^(\w+):\s*(.+?)\s*$/.exec(content) ?? [];
    if (key === undefined || !KEYS.includes(key))
      throw new ScenarioError(`line ${from + k}`, `a line here is "key: value", the key one of ${KEYS.join(', ')}`);
    fields.set(key, { value: value!, line: from + k });
  });
  return fields;
}

function need(fields: Fields, key: string, line: number): string {
  const found = fields.get(key);
  if (!found) throw new ScenarioError(`line ${line}`, `this block needs a line "${key}: …"`);
  return found.value;
}

function subjectOf(fields: Fields, line: number): Subject {
  const id = fields.get('case');
  if (id) return { case: id.value };
  const text = need(fields, 'scenario', line);
  let scenario: unknown;
  try {
    scenario = JSON.parse(text);
  } catch {
    scenario = null;
  }
  if (typeof scenario !== 'object' || scenario === null || Array.isArray(scenario))
    throw new ScenarioError(
      `line ${fields.get('scenario')!.line}`,
      'the scenario is JSON in one line: {"version": 1, …}',
    );
  return { scenario: scenario as Record<string, unknown> };
}

function liveOf(fields: Fields, line: number): Block {
  const vary = fields.get('vary');
  const [, group, name, from, to] = /^(parameters|initial)\.(\w+) (\S+) (\S+)$/.exec(vary?.value ?? '') ?? [];
  const [low, high] = [Number(from), Number(to)];
  if (vary && !(low < high))
    throw new ScenarioError(`line ${vary.line}`, 'right would be: vary: parameters.casterTrail -0.06 0.06');
  const plot = fields.get('plot');
  const [, y = '', x = 't'] = /^((?:\w+ )*?\w+)(?: over (\w+))?$/.exec(plot?.value ?? '') ?? [];
  if (plot && y === '')
    throw new ScenarioError(`line ${plot.line}`, 'right would be: plot: alpha beta, or plot: Y over X');
  return {
    kind: 'live',
    line,
    title: need(fields, 'title', line),
    subject: subjectOf(fields, line),
    vary: vary ? { path: [group!, name!], from: low, to: high } : null,
    plot: plot ? { x, y: y.split(' ') } : null,
  };
}

function questionOf(fields: Fields, line: number): Block {
  const answer = need(fields, 'answer', line);
  const [, kind, column = ''] = /^(end|max|min|range|time|growth)(?: (\S+))?$/.exec(answer) ?? [];
  const alone = kind === 'time' || kind === 'growth';
  if (kind === undefined || alone !== (column === ''))
    throw new ScenarioError(
      `line ${fields.get('answer')!.line}`,
      'an answer is computed: end, max, min or range with a column, or time, or growth',
    );
  const number = (key: string, otherwise: number): number => {
    const found = fields.get(key);
    const x = found ? Number(found.value.replace(/\s*%$/, '')) / (found.value.endsWith('%') ? 100 : 1) : otherwise;
    if (!Number.isFinite(x) || x === 0) throw new ScenarioError(`line ${found!.line}`, `${key} is a number`);
    return x;
  };
  return {
    kind: 'question',
    line,
    text: need(fields, 'ask', line),
    unit: fields.get('unit')?.value ?? '1',
    tolerance: Math.abs(number('tolerance', 0.01)),
    hint: fields.get('hint')?.value ?? '',
    subject: subjectOf(fields, line),
    ask: { kind: kind as Ask['kind'], column },
    times: number('times', 1),
  };
}
