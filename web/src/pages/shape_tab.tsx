// The sub-domains of a job in space, as they are made: coloured by what one wants to know of them,
// pulled apart, turned; and the same as words and as a table.

import { useEffect, useMemo, useRef, useState } from 'preact/hooks';
import type { ColumnTable } from '../api/columns';
import { useAnswer, useLive } from '../api/hooks';
import { inAddress } from '../api/client';
import type { LoadedMap } from '../api/map_loader';
import { useMapSurfaces } from '../api/map_loader';
import type { LoadedSurface } from '../api/surface_loader';
import { SurfaceLoader } from '../api/surface_loader';
import type { Job, MapLine, MapList, SurfaceLine, SurfaceList } from '../api/types';
import { counted, duration, figure, whole } from '../logic/format';
import { colouringOfDefects, colouringOfLayers } from '../logic/job_maps';
import type { Meshing } from '../logic/meshing_tasks';
import { meshingOf } from '../logic/meshing_tasks';
import type { WorstPlace } from '../logic/quality';
import { worstPlaceOf } from '../logic/quality';
import { taskAddress } from '../logic/router';
import type { Cut } from '../logic/section';
import { placeOfCut } from '../logic/section';
import type { ShapeSettings } from '../logic/shape_settings';
import type { ShownSurface } from '../logic/shown_surface';
import { addBox, boxOf, emptyBox, trianglesForEach } from '../logic/shown_surface';
import type { ShownSubdomain } from '../logic/shown_subdomains';
import { colouringOf, stateWords } from '../logic/shown_subdomains';
import { sortedRows } from '../logic/sort_filter';
import { isJobLive } from '../logic/states';
import type { LegendLine, Way } from '../logic/surface_colours';
import { cssColour, unknownColour, ways, wayWords } from '../logic/surface_colours';
import { goTo } from '../ui/navigation';
import { Empty, Name, TaskLink, Trouble, Waiting } from '../ui/parts';
import type { Column, Sorting } from '../ui/virtual_table';
import { VirtualTable } from '../ui/virtual_table';
import { ShapeCanvas } from './shape_canvas';
import { ShapeControls } from './shape_controls';
import { useShapeSettings } from './shape_hash';
import type { Overlay } from './shape_scene';

function shownOf(line: SurfaceLine, meshing: Meshing | undefined): ShownSubdomain {
  return {
    path: line.path,
    place: line.place,
    state: line.meshed ? 'done' : line.state === 'open' ? 'whole' : meshing?.isRunning ? 'runs' : 'waits',
    worker: meshing?.worker ?? '',
    seconds: meshing?.seconds ?? 0,
    angle: meshing?.angle ?? 0,
    task: meshing?.task ?? 0,
  };
}

/** The sub-domains that are there, asked again while the job lives and when it has others. */
function useSurfaceList(job: Job) {
  const isLive = isJobLive(job.state);
  const asked = useAnswer<SurfaceList>(`/jobs/${inAddress(job.job)}/surfaces`, isLive ? 5000 : undefined);
  const line = useLive().jobs?.find((other) => other.job === job.job);
  const now = `${line?.state} ${line?.subdomains} ${line?.subdomains_meshed}`;
  const before = useRef(now);
  useEffect(() => {
    if (before.current !== now) asked.ask();
    before.current = now;
  }, [now]);
  return asked;
}

/** While many come, they are drawn together. */
const drawEveryMs = 250;

/** What of them has come. */
function useSurfaces(job: string, list: SurfaceList | undefined) {
  const [loaded, set] = useState<{ surfaces: LoadedSurface[]; toCome: number; failed: number; trouble: string }>({
    surfaces: [], toCome: 0, failed: 0, trouble: '',
  });
  const loader = useRef<SurfaceLoader>();
  useEffect(() => {
    let timer = 0;
    const tell = () => {
      timer = 0;
      const { count, trouble } = own.failed();
      set({ surfaces: own.loaded(), toCome: own.toCome(), failed: count, trouble });
    };
    const own = new SurfaceLoader(job, () => (timer ||= window.setTimeout(tell, drawEveryMs)));
    loader.current = own;
    return () => {
      own.stop();
      window.clearTimeout(timer);
    };
  }, [job]);
  useEffect(() => {
    if (!list) return;
    const there = list.surfaces.filter((line) => line.is_there);
    loader.current?.update(there, trianglesForEach(there.length));
  }, [job, list]);
  return loaded;
}

function Legend({ way, lines, remark }: { way: Way; lines: readonly LegendLine[]; remark: string }) {
  return (
    <>
      <ul class="legend" aria-label={`Colours: ${wayWords[way]}`}>
        {lines.map(({ words, colour, count }, index) => (
          <li key={index}>
            <span class="sample" style={{ backgroundColor: cssColour(colour) }} aria-hidden="true" />
            <bdi>{words}</bdi>
            {count !== undefined && <span class="faint">{whole(count)}</span>}
          </li>
        ))}
      </ul>
      {remark && <p class="faint">{remark}</p>}
    </>
  );
}

/** Why there is nothing, or not all, to be seen. */
function Missing({ list, failed, trouble }: { list: SurfaceList; failed: number; trouble: string }) {
  const gone = list.surfaces.filter((line) => !line.is_there).length;
  if (!list.sees_files) {
    return (
      <div class="callout" role="note">
        The dashboard does not see the files of the store, so there is nothing to draw. Start it with{' '}
        <code>--store DIR</code>, beside <code>--connect</code> where that is used.
      </div>
    );
  }
  return (
    <>
      {gone > 0 && (
        <p class="faint">
          {counted(gone, 'sub-domain')} cannot be drawn: the file is no longer in the store, or is too large.
        </p>
      )}
      {list.left_out > 0 && <p class="faint">{counted(list.left_out, 'more sub-domain')} left out.</p>}
      {failed > 0 && (
        <p class="warn" role="alert">
          {counted(failed, 'sub-domain')} did not come: <Name text={trouble} longest={200} />
        </p>
      )}
    </>
  );
}

function Summary({ list, loaded, toCome }: { list: SurfaceList; loaded: readonly LoadedSurface[]; toCome: number }) {
  const drawn = loaded.reduce((sum, { surface }) => sum + surface.pieces.length, 0);
  const of = loaded.reduce((sum, { surface }) => sum + surface.wholeTriangles, 0);
  const meshed = list.surfaces.filter((line) => line.meshed).length;
  return (
    <p role="status" class="shape-summary">
      {`${whole(loaded.length)} of ${counted(list.surfaces.length + list.left_out, 'sub-domain')} are here, ${whole(meshed)} meshed. `}
      {drawn < of
        ? `Their boundaries have ${whole(of)} triangles, of which ${whole(drawn)} stand for them here. `
        : `Their boundaries have ${whole(of)} triangles. `}
      {toCome > 0 && `${whole(toCome)} still to come.`}
    </p>
  );
}

const tableColumns: { key: keyof ShownSubdomain; words: string; isNumber?: boolean; isExtra?: boolean }[] = [
  { key: 'place', words: 'Sub-domain' },
  { key: 'state', words: 'State' },
  { key: 'worker', words: 'Worker' },
  { key: 'seconds', words: 'Seconds', isNumber: true },
  { key: 'angle', words: 'Smallest angle', isNumber: true, isExtra: true },
  { key: 'task', words: 'Task', isNumber: true },
];

function cellOf(shown: ShownSubdomain, key: keyof ShownSubdomain) {
  if (key === 'state') return stateWords[shown.state] ?? '';
  if (key === 'seconds') return shown.seconds > 0 ? duration(shown.seconds) : '–';
  if (key === 'angle') return shown.angle > 0 ? `${figure(shown.angle)}°` : '–';
  if (key === 'task') return <TaskLink task={shown.task} />;
  return <Name text={String(shown[key]) || '–'} longest={40} />;
}

function Table({ shown }: { shown: readonly ShownSubdomain[] }) {
  const [sorting, sort] = useState<Sorting>({ key: 'place', descending: false });
  const columns: Column[] = tableColumns.map(({ key, words, isNumber, isExtra }) => ({
    key, words, isNumber: isNumber === true, isExtra: isExtra === true, cell: (row) => cellOf(shown[row]!, key),
  }));
  const rows = sortedRows(
    Uint32Array.from(shown, (_, i) => i),
    (row) => shown[row]![sorting.key as keyof ShownSubdomain],
    sorting.descending,
  );
  return (
    <VirtualTable
      label="Sub-domains"
      columns={columns}
      rows={rows}
      rowKey={(row) => shown[row]!.path}
      sorting={sorting}
      onSort={sort}
      onOpen={(row) => shown[row]!.task > 0 && goTo(taskAddress(shown[row]!.task))}
    />
  );
}

function Chosen({ shown }: { shown: ShownSubdomain | undefined }) {
  return (
    <p class="tip" role="status">
      {!shown && 'Drag or arrow keys turn, the wheel or + and − zoom, Shift moves, 0 shows all. A click tells of a sub-domain.'}
      {shown && (
        <>
          <strong><Name text={shown.place} longest={70} /></strong>: {stateWords[shown.state]}
          {shown.worker && <>, <Name text={shown.worker} longest={40} /></>}
          {shown.seconds > 0 && `, ${duration(shown.seconds)}`}
          {shown.angle > 0 && `, smallest angle ${figure(shown.angle)}°`}
          {shown.task > 0 && <>, task <TaskLink task={shown.task} /></>}
        </>
      )}
    </p>
  );
}

const noMaps: readonly MapLine[] = [];
const noSurfaces: ReadonlyMap<number, ShownSurface> = new Map();
const trianglesOfDefects = 32_768;
const trianglesOfLayers = 131_072;

/** The maps of a job that has ended: only then are there any. */
function useMaps(job: Job, way: Way) {
  const path = isJobLive(job.state) ? undefined : `/jobs/${inAddress(job.job)}/maps`;
  const maps = useAnswer<MapList>(path).value?.maps ?? noMaps;
  const [defects, layers] = useMemo(() => {
    const of = (what: string) => maps.filter((line) => line.of === what && line.is_there);
    return [of('defects'), of('layers')];
  }, [maps]);
  const drawnDefects = useMapSurfaces(job.job, defects, trianglesOfDefects);
  const drawnLayers = useMapSurfaces(job.job, way === 'layers' ? layers : noMaps, trianglesOfLayers);
  return { maps, hasLayers: layers.length > 0, defects: drawnDefects, layers: drawnLayers };
}

type Maps = ReturnType<typeof useMaps>;

/** How the maps are drawn: defects through everything, layers in place of the sub-domains. */
function overlaysOf(loaded: readonly LoadedMap[], of: 'defects' | 'layers'): { overlays: Overlay[]; legend: LegendLine[] } {
  const surfaces = loaded.map(({ surface }) => surface);
  const { ofPiece, legend } =
    of === 'layers' ? colouringOfLayers(surfaces) : colouringOfDefects(surfaces, loaded.map(({ line }) => line.meanings));
  const overlays = surfaces.map((surface, map) => ({
    surface, colourOf: (piece: number) => ofPiece(map, piece), isOnTop: of === 'defects',
  }));
  return { overlays, legend };
}

/** Defects in words: what they are, in how many triangles, and what cannot be shown of them. */
function Defects({ maps }: { maps: Maps }) {
  const lost = maps.maps.filter((line) => !line.is_there);
  const triangles = maps.defects.loaded.reduce((sum, { surface }) => sum + surface.wholeTriangles, 0);
  const trouble = maps.defects.trouble || maps.layers.trouble;
  return (
    <>
      {triangles > 0 && (
        <p role="status" class="shape-defects">
          {counted(triangles, 'triangle')} with defects, drawn through what lies before them:{' '}
          {[...new Set(maps.defects.loaded.flatMap(({ line }) => line.meanings))].map((words, index) => (
            <>{index > 0 && ', '}<Name text={words} longest={60} /></>
          ))}.
        </p>
      )}
      {lost.map((line) => (
        <p key={line.map} class="faint">
          <code><Name text={line.file} longest={80} /></code> cannot be drawn: the file is not seen in the store, or is too large.
        </p>
      ))}
      {trouble && <p class="warn" role="alert">A map did not come: <Name text={trouble} longest={200} /></p>}
    </>
  );
}

interface ViewProps {
  worst: WorstPlace | undefined;
  list: SurfaceList;
  loaded: readonly LoadedSurface[];
  shown: readonly ShownSubdomain[];
  maps: Maps;
  settings: ShapeSettings;
  change: (change: Partial<ShapeSettings>) => void;
}

/** The colours of the sub-domains, and what they mean. */
function useColouring({ list, loaded, shown }: ViewProps, way: Way) {
  const pieces = useMemo(() => {
    const found = new Set<number>();
    for (const { surface } of loaded) for (const kind of surface.kinds) found.add(kind);
    return found;
  }, [loaded]);
  return useMemo(() => {
    const made = colouringOf(way, shown, list.patches, pieces);
    const path2colour = new Map(shown.map((one) => [one.path, made.ofSubdomain(one)]));
    return {
      colouring: made,
      colourOf: (path: number, piece: number) =>
        path2colour.has(path) ? path2colour.get(path) ?? made.ofPiece(piece) : unknownColour,
    };
  }, [way, shown, list, pieces]);
}

/** Where the plane is that cuts what is drawn. */
function useCut({ cut: axis, at, keepsAbove }: ShapeSettings, drawn: readonly ShownSurface[]): Cut | undefined {
  const box = useMemo(() => {
    const all = emptyBox();
    for (const surface of drawn) addBox(all, boxOf(surface));
    return all;
  }, [drawn]);
  return useMemo(() => axis && { axis, at: placeOfCut(box, axis, at / 100), keepsAbove }, [box, axis, at, keepsAbove]);
}

function SpaceView(props: ViewProps) {
  const { loaded, shown, worst, maps, settings, change } = props;
  const [chosen, choose] = useState<number>();
  const way = settings.way === 'layers' && !maps.hasLayers ? 'subdomain' : settings.way;
  const isOfLayers = way === 'layers';
  const { colouring, colourOf } = useColouring(props, way);
  const layers = useMemo(() => overlaysOf(maps.layers.loaded, 'layers'), [maps.layers.loaded]);
  const defects = useMemo(() => overlaysOf(maps.defects.loaded, 'defects'), [maps.defects.loaded]);
  const overlays = useMemo(
    () => [...(isOfLayers ? layers.overlays : []), ...(settings.marks ? defects.overlays : [])],
    [isOfLayers, layers, defects, settings.marks],
  );
  const surfaces = useMemo(
    () => (isOfLayers ? noSurfaces : new Map(loaded.map(({ line, surface }) => [line.path, surface]))),
    [loaded, isOfLayers],
  );
  const drawn = useMemo(() => [...surfaces.values(), ...overlays.map(({ surface }) => surface)], [surfaces, overlays]);
  const cut = useCut(settings, drawn);
  const ofMaps = isOfLayers ? layers.legend : shown.length > 0 ? colouring.legend : [];
  return (
    <>
      <ShapeControls
        settings={{ ...settings, way }}
        change={change}
        ways={ways.filter((one) => one !== 'layers' || maps.hasLayers)}
        worst={worst}
        hasDefects={defects.overlays.length > 0}
        cutAt={cut?.at ?? 0}
      />
      <ShapeCanvas
        surfaces={surfaces}
        colourOf={colourOf}
        exploded={settings.apart / 100}
        mark={settings.marks ? worst?.at : undefined}
        cut={cut}
        overlays={overlays}
        label={`The job’s sub-domains in space, coloured by ${wayWords[way].toLowerCase()}. Arrow keys turn, plus and minus zoom, 0 shows all. The table below has the same.`}
        onChoose={choose}
      />
      <Chosen shown={shown.find(({ path }) => path === chosen)} />
      <Legend way={way} lines={[...ofMaps, ...(settings.marks ? defects.legend : [])]} remark={isOfLayers ? '' : colouring.remark} />
    </>
  );
}

interface TabProps {
  job: Job;
  tasks: ColumnTable | undefined;
  attempts: ColumnTable | undefined;
}

export function ShapeTab({ job, tasks, attempts }: TabProps) {
  const asked = useSurfaceList(job);
  const list = asked.value;
  const [settings, change] = useShapeSettings();
  const { surfaces: loaded, toCome, failed, trouble } = useSurfaces(job.job, list);
  const maps = useMaps(job, settings.way);
  const shown = useMemo(() => {
    const meshing = meshingOf(tasks, attempts);
    return (list?.surfaces ?? []).map((line) => shownOf(line, meshing.get(line.path)));
  }, [list, tasks, attempts]);
  const worst = useMemo(() => worstPlaceOf(job.result), [job.result]);
  if (!list) return asked.error ? <Trouble error={asked.error} /> : <Waiting what="Asking for the sub-domains…" />;
  const hasSubdomains = list.surfaces.length > 0;
  if (!hasSubdomains && maps.maps.length === 0) return <Empty>No sub-domains yet.</Empty>;
  const view = { list, loaded, shown, worst, maps, settings, change };
  return (
    <>
      <Trouble error={asked.error} isKnown />
      {hasSubdomains && <Summary list={list} loaded={loaded} toCome={toCome} />}
      <Missing list={list} failed={failed} trouble={trouble} />
      <Defects maps={maps} />
      {list.sees_files && <SpaceView {...view} />}
      {hasSubdomains && <h2>Sub-domains</h2>}
      {hasSubdomains && <Table shown={shown} />}
    </>
  );
}
