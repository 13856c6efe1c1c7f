/** What the status line says of the network: a file on its way, and that there is none. */
import { useEffect, useState } from 'preact/hooks';
import { fileText, offlineText } from '../../app/words.ts';
import { useUi } from '../context.ts';

export function Connection() {
  const loading = useUi().app.state.loading.value;
  const offline = useOffline();
  return (
    <>
      {loading && (
        <span class="standing" data-testid="loading">
          <progress max={1} value={loading.share ?? undefined} aria-label={fileText.loading(loading.name)} />
          {fileText.loading(loading.name)}
          {loading.share !== null && ` ${Math.floor(100 * loading.share)} %`}
        </span>
      )}
      <span role="status">
        {offline && (
          <span class="offline" title={offlineText.offlineTitle} data-testid="offline">
            {offlineText.offline}
          </span>
        )}
      </span>
    </>
  );
}

function useOffline(): boolean {
  const [offline, setOffline] = useState(!navigator.onLine);
  useEffect(() => {
    const listen = () => setOffline(!navigator.onLine);
    addEventListener('online', listen);
    addEventListener('offline', listen);
    return () => {
      removeEventListener('online', listen);
      removeEventListener('offline', listen);
    };
  }, []);
  return offline;
}
