/** A table as CSV; text with commas or quotes is quoted, what is not a number is empty. */
export function csvText(headings: readonly string[], rows: readonly (readonly (string | number | null)[])[]): string {
  const cell = (value: string | number | null): string => {
    if (value === null || (typeof value === 'number' && !Number.isFinite(value))) return '';
    const text = String(value);
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return `${[headings, ...rows].map((row) => row.map(cell).join(',')).join('\n')}\n`;
}
