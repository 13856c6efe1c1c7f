/** A part of the page on its way, or why it did not come. */
import { useEffect, useState } from 'preact/hooks';
import { words } from './words.ts';

export function LoadingPart({ failed }: { failed: boolean }) {
  const [outdated, setOutdated] = useState(false);
  useEffect(() => {
    if (failed) void pageChanged().then(setOutdated);
  }, [failed]);
  return (
    <div class="hint pad" role={failed ? 'alert' : 'status'}>
      {!failed ? words.loading : outdated ? words.outdated : words.failed}
      {outdated && (
        <>
          {' '}
          <button type="button" class="link" data-testid="reload" onClick={() => location.reload()}>
            {words.reload}
          </button>
        </>
      )}
    </div>
  );
}

/** Whether the server has another build than this page: then what this one would load is not there any more. */
export async function pageChanged(): Promise<boolean> {
  const own = document.querySelector('script[type=module][src]')?.getAttribute('src');
  if (!own) return false;
  try {
    const response = await fetch(location.pathname, { cache: 'no-store' });
    return response.ok && !(await response.text()).includes(own);
  } catch {
    return false;
  }
}
