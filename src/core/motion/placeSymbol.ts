import type { SystemMeta } from '../model/system.ts';
import { columnOf, symbolOf } from './columns.ts';
import { symbolText, words, type Text } from './symbols.ts';

/**
 * The symbol of a place in a scenario: of a parameter or a state its own, of all else a name.
 *
 * @param path `initial.alpha`; of several joined by `+` the first counts
 * @param label what it is called where it has no symbol
 * @param meta of the system
 */
export function placeSymbol(path: string, label: string, meta: SystemMeta): Text {
  const [first] = path.split('+');
  const [, group, name] = /^(parameters|initial|control\.at)\.(.+)$/.exec(first!) ?? [];
  const parameter = group === 'parameters' && meta.parameters.find((p) => p.name === name);
  if (parameter) return symbolText(parameter.symbol);
  if (name === meta.speed?.name && name !== undefined) return symbolText('v');
  return group && group !== 'parameters' ? symbolOf(columnOf(meta, name!)) : words(label);
}
