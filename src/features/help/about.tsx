import dependencies from '../../../docs/dependencies.md?raw';
import { words } from './words.ts';

declare const __RIPSTIK_VERSION__: string;
declare const __RIPSTIK_SITE__: string;

export function About() {
  return (
    <div class="help-text" data-testid="about">
      <h3>{words.version(__RIPSTIK_VERSION__)}</h3>
      {words.aboutParts.map((part) => (
        <p key={part}>{part}</p>
      ))}
      <p>{words.licence}</p>
      <p>
        {__RIPSTIK_SITE__ ? (
          <a href={`${__RIPSTIK_SITE__}index.html`} target="_blank" rel="noopener">
            {words.site}
          </a>
        ) : (
          words.noSite
        )}
      </p>
    </div>
  );
}

/** Rows of the table of packages that the page carries. */
const carried = (): string[][] =>
  dependencies
    .slice(dependencies.indexOf('| In the page'), dependencies.indexOf('| On the command line'))
    .split('\n')
    .filter((line) => line.startsWith('|'))
    .slice(2)
    .map((line) => line.split('|').map((cell) => cell.trim()));

export function Licences() {
  return (
    <div class="help-text" data-testid="licences">
      <p>{words.own}</p>
      <table>
        <tbody>
          {carried().map(([, name, version, licence]) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{version}</td>
              <td>{licence}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p>
        <a href="./licences.txt" target="_blank" rel="noopener">
          {words.texts}
        </a>
      </p>
    </div>
  );
}
