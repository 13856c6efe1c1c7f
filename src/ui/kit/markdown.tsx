/** As much of Markdown as our documents use: headings, paragraphs, lists, tables, code, emphasis, links. No markup passes through. */
import type { ComponentChildren, VNode } from 'preact';
import { idOf } from '../glossaryText.ts';
import { Math } from './math.tsx';

/** What opens a file, with a place in it; null where it can't be opened. */
type LinkOf = (file: string, place: string) => (() => void) | null;

const INLINE = /`([^`]+)`|\$([^$]+)\$|\*\*([^*]+)\*\*|(?<![\w*])\*([^*\s][^*]*)\*(?![\w*])|!?\[([^\]]*)\]\(([^)]+)\)/g;

function inline(text: string, linkOf: LinkOf): ComponentChildren[] {
  const parts: ComponentChildren[] = [];
  let from = 0;
  for (const found of text.matchAll(INLINE)) {
    const [whole, code, math, strong, emphasis, label, target] = found;
    parts.push(text.slice(from, found.index));
    from = found.index + whole.length;
    if (code !== undefined) parts.push(<code>{code}</code>);
    else if (math !== undefined) parts.push(<Math latex={math} />);
    else if (strong !== undefined) parts.push(<strong>{inline(strong, linkOf)}</strong>);
    else if (emphasis !== undefined) parts.push(<em>{emphasis}</em>);
    else if (whole.startsWith('!')) parts.push(label);
    else parts.push(link(label!, target!, linkOf));
  }
  parts.push(text.slice(from));
  return parts;
}

function link(label: string, target: string, linkOf: LinkOf): ComponentChildren {
  if (/^https:\/\//.test(target))
    return (
      <a href={target} target="_blank" rel="noopener noreferrer">
        {label}
      </a>
    );
  const [file = '', place = ''] = target.split('#');
  const open = linkOf(file.replace(/^\.\//, ''), place);
  return open ? (
    <button type="button" class="link" onClick={open}>
      {label}
    </button>
  ) : (
    label
  );
}

const cells = (line: string): string[] =>
  line
    .replace(/^\||\|\s*$/g, '')
    .split(/(?<!\\)\|/)
    .map((cell) => cell.trim().replaceAll('\\|', '|'));

function table(lines: readonly string[], linkOf: LinkOf): VNode {
  const [head, , ...rows] = lines.map(cells);
  return (
    <div class="table-scroll" tabIndex={0} role="region" aria-label={head!.filter(Boolean).join(', ') || undefined}>
      <table>
        <thead>
          <tr>
            {head!.map((cell, i) => (
              <th key={i} scope="col">
                {inline(cell, linkOf)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row, i) => (
            <tr key={i}>
              {row.map((cell, j) => (
                <td key={j}>{inline(cell, linkOf)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const ITEM = /^(?:[-*]|\d+\.) /;

function list(lines: readonly string[], linkOf: LinkOf): VNode {
  const items: string[] = [];
  for (const line of lines) {
    if (ITEM.test(line)) items.push(line.replace(ITEM, ''));
    else items.push(`${items.pop() ?? ''} ${line.trim()}`);
  }
  const shown = items.map((item, i) => <li key={i}>{inline(item, linkOf)}</li>);
  return /^\d/.test(lines[0]!) ? <ol>{shown}</ol> : <ul>{shown}</ul>;
}

function block(lines: readonly string[], linkOf: LinkOf): VNode {
  const [first = ''] = lines;
  const heading = /^(#{1,6}) (.*)/.exec(first);
  if (heading) {
    const place = { 'data-place': idOf(heading[2]!) };
    return heading[1]!.length === 1 ? <h3 {...place}>{heading[2]}</h3> : <h4 {...place}>{heading[2]}</h4>;
  }
  if (first.startsWith('|')) return table(lines, linkOf);
  if (ITEM.test(first)) return list(lines, linkOf);
  return <p>{inline(lines.join(' '), linkOf)}</p>;
}

export function Markdown({ text, linkOf }: { text: string; linkOf: LinkOf }) {
  const out: VNode[] = [];
  // In threes: text, the language of what is fenced, what is fenced.
  text.split(/^```(\w*)$\n([\s\S]*?)^```$/m).forEach((part, i, parts) => {
    if (i % 3 === 1) return;
    if (i % 3 === 2) {
      const formula = parts[i - 1] === 'math';
      out.push(formula ? <Math latex={part.trim()} display /> : <pre tabIndex={0}>{part.trimEnd()}</pre>);
      return;
    }
    const blocks = part.replace(/^(#{1,6} .*)$/gm, '\n$1\n').split(/\n\s*\n/);
    for (const lines of blocks.map((one) => one.split('\n').filter((line) => line.trim() !== '')))
      if (lines.length > 0) out.push(block(lines, linkOf));
  });
  return <>{out}</>;
}
