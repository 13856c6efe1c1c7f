/** A row or cell that could not be used; line and column as a person counts them, 0 and empty for the whole file. */
export interface CsvIssue {
  line: number;
  /** Last line, where the same holds for lines that follow one another. */
  to?: number;
  column: string;
  message: string;
}

const MOST_ISSUES = 1000;

/** What could not be used, in ranges of lines. */
export class Issues {
  private readonly list: CsvIssue[] = [];
  private unnamed = 0;

  add(line: number, column: string, message: string): void {
    const last = this.list.at(-1);
    if (last && last.column === column && last.message === message && line === (last.to ?? last.line) + 1)
      last.to = line;
    else if (this.list.length < MOST_ISSUES) this.list.push({ line, column, message });
    else this.unnamed++;
  }

  /** In the order of the file; the last one counts those beyond the first 1,000. */
  sorted(): CsvIssue[] {
    const sorted = [...this.list].sort((a, b) => a.line - b.line);
    if (this.unnamed > 0) sorted.push({ line: 0, column: '', message: `and ${this.unnamed} more` });
    return sorted;
  }
}
