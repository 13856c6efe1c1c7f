/** A text that is no allowed expression: what is wrong, where, what would be right. */
export class ExpressionError extends Error {
  /** 0-based character in the text as given, or null when it concerns the whole. */
  readonly position: number | null;
  constructor(message: string, position: number | null = null) {
    super(position === null ? message : `${message} (at character ${position + 1})`);
    this.name = 'ExpressionError';
    this.position = position;
  }
}
