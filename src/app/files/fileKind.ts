/** What a file is, by its name and its first bytes. */

/** Bytes that are looked at. */
const LOOKED_AT = 4096;

/** `system`: a description of one's own; `study`: a Parquet file; `lesson`: Markdown; `table`: anything else, the reader knows containers and says what to do with them. */
export type FileKind = 'scenario' | 'system' | 'mesh' | 'study' | 'lesson' | 'table';

/**
 * `.mat` is a material of a mesh only as text: MATLAB's own files begin with its name, HDF5 or a binary header.
 * JSON is a scenario where it names a system or a version; records of numbers are a table.
 */
export async function kindOf(name: string, file: Blob): Promise<FileKind> {
  if (/\.mdl$/i.test(name)) return 'mesh';
  if (/\.system\.txt$/i.test(name)) return 'system';
  if (/\.(md|markdown)$/i.test(name)) return 'lesson';
  const start = new Uint8Array(await file.slice(0, LOOKED_AT).arrayBuffer());
  if (/\.mat$/i.test(name)) return isText(start) ? 'mesh' : 'table';
  const text = new TextDecoder().decode(start);
  if (text.startsWith('PAR1')) return 'study';
  const braces = /^\s*\{/.test(text);
  if (braces && /"(?:system|version)"\s*:/.test(text)) return /\.(csv|txt|tsv)$/i.test(name) ? 'table' : 'scenario';
  return /\.json$/i.test(name) && !/^\s*[[{]/.test(text) ? 'scenario' : 'table';
}

function isText(start: Uint8Array): boolean {
  return !start.includes(0) && !new TextDecoder().decode(start.subarray(0, 6)).startsWith('MATLAB');
}
