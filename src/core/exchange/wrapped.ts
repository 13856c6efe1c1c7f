/**
 * Text as lines of a comment.
 *
 * @param text of one paragraph
 * @param width of a line, in characters
 */
export function wrapped(text: string, width = 96): string[] {
  return text.match(new RegExp(`.{1,${width}}(?:\\s|$)`, 'g'))?.map((line) => line.trimEnd()) ?? [text];
}
