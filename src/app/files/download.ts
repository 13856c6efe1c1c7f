/** Offers data to the person as a file. */
export function download(name: string, parts: BlobPart[], type: string): void {
  const url = URL.createObjectURL(new Blob(parts, { type }));
  const link = document.createElement('a');
  link.href = url;
  link.download = name;
  link.click();
  // The browser reads the address when the click is handled; a minute covers a slow save dialog.
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
