/** A button that has a file chosen; the same file can be chosen again. */
import { useRef } from 'preact/hooks';

export function FileButton({
  label,
  accept,
  testId,
  onFile,
}: {
  label: string;
  /** Endings and types, as in `<input accept>`. */
  accept: string;
  /** Of the field that takes the file. */
  testId: string;
  onFile(file: File): void;
}) {
  const field = useRef<HTMLInputElement>(null);
  return (
    <>
      <button type="button" onClick={() => field.current?.click()}>
        {label}
      </button>
      <input
        ref={field}
        type="file"
        class="hidden"
        tabIndex={-1}
        aria-hidden="true"
        accept={accept}
        data-testid={testId}
        onChange={({ currentTarget: input }) => {
          const file = input.files?.[0];
          input.value = '';
          if (file) onFile(file);
        }}
      />
    </>
  );
}

/** The text of a file, without the mark that some tools begin it with. */
export const textOfFile = (file: Blob): Promise<string> => file.text().then((text) => text.replace(/^\ufeff/, ''));
