// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// How the preview page shows a set: where its data is, its colours, its light. Loaded before preview.js and
// used once CesiumJS is there.
"use strict";
const terrainLook = (() => {
  // Colours from the lowest to the highest place; sea and land meet at 0 m.
  const SEA = ["#16324a", "#2b5a78", "#5f93a8", "#a9c8cb"];
  const LAND = ["#7f9c76", "#b3b886", "#d3bf8f", "#b8926a", "#a58573", "#d9d3cd", "#f7f6f4"];
  const WGS84_E2 = 0.00669437999014;

  function formatHeight(height, digits) {
    return height.toLocaleString("en", { minimumFractionDigits: digits, maximumFractionDigits: digits })
      .replaceAll(",", "\u202f").replace("-", "\u2212");
  }

  // ---- Where the data is ----------------------------------------------------------------------

  /** West and east, in turns of the globe from 180 W, of the shortest arc that holds all tiles of a level. */
  function arcOf(ranges, columns) {
    const starts = ranges.map(({ startX, endX }) => [startX / columns, (endX + 1) / columns])
      .sort((one, other) => one[0] - other[0]);
    let [west, east] = [starts[0][0], starts[0][1]];
    let widestGap = 0;
    let reached = starts[0][1];
    for (const [start, end] of [...starts.slice(1), [starts[0][0] + 1, 0]]) {
      if (start - reached > widestGap) {
        widestGap = start - reached;
        [west, east] = [start % 1, reached];
      }
      reached = Math.max(reached, end);
    }
    return widestGap === 0 ? [0, 1] : [west, east];
  }

  /**
   * Where the data is; across the antimeridian east is less than west, as Cesium.Rectangle has it. The
   * layer.json of data that cross it has bounds all round the globe: then the columns of its deepest level tell.
   */
  function boundsOf(layer) {
    const [west, south, east, north] = layer.bounds ?? [-180, -90, 180, 90];
    const wrap = (lon) => (lon > 180 ? lon - 360 : lon < -180 ? lon + 360 : lon);
    if (east - west < 360) return Cesium.Rectangle.fromDegrees(wrap(west), south, wrap(east), north);
    const level = layer.available.length - 1;
    const roots = layer.projection === "EPSG:3857" ? 1 : 2;
    const [first, last] = arcOf(layer.available[level], roots * 2 ** level);
    return Cesium.Rectangle.fromDegrees(first * 360 - 180, south, last * 360 - 180, north);
  }

  /** The deepest level at which few tiles cover the bounds. */
  function overviewLevel(provider, bounds, maxLevel) {
    const mostTiles = 32;
    const root = provider.tilingScheme.tileXYToRectangle(0, 0, 0);
    let level = 0;
    while (level < maxLevel) {
      const tiles = (bounds.width / root.width) * (bounds.height / root.height) * 4 ** (level + 1);
      if (tiles > mostTiles) break;
      ++level;
    }
    return level;
  }

  /** A lattice of places over the bounds, those that have a tile of the level. */
  function placesWithTiles(provider, bounds, level) {
    const steps = 40;
    const places = [];
    for (let row = 0; row < steps; ++row) {
      for (let column = 0; column < steps; ++column) {
        const latitude = bounds.south + (bounds.height * (row + 0.5)) / steps;
        const longitude = Cesium.Math.convertLongitudeRange(
          bounds.west + (bounds.width * (column + 0.5)) / steps);
        const place = new Cesium.Cartographic(longitude, latitude);
        const tile = provider.tilingScheme.positionToTileXY(place, level);
        if (tile && provider.getTileDataAvailable(tile.x, tile.y, level)) places.push(place);
      }
    }
    return places;
  }

  /**
   * Heights that 1 % of the area is below and 99.5 % is below, in metres. Places at exactly 0 m do not count
   * where there are others: mostly they are voids, filled.
   */
  async function heightRange(provider, bounds, maxLevel) {
    const level = overviewLevel(provider, bounds, maxLevel);
    const places = await Cesium.sampleTerrain(provider, level, placesWithTiles(provider, bounds, level));
    const all = places.map((place) => place.height).filter(Number.isFinite).sort((a, b) => a - b);
    const notZero = all.filter((height) => Math.abs(height) > 0.01);
    const heights = notZero.length > 0.05 * all.length ? notZero : all;
    if (heights.length === 0) return [0, 1];
    const low = heights[Math.floor(0.01 * (heights.length - 1))];
    const high = heights[Math.floor(0.995 * (heights.length - 1))];
    return [low, Math.max(high, low + 1)];
  }

  function lookAt(viewer, bounds, middleHeight) {
    if (bounds.width > Cesium.Math.toRadians(120) || bounds.height > Cesium.Math.toRadians(100)) {
      const { longitude, latitude } = Cesium.Rectangle.center(bounds);
      const north = Math.abs(latitude) < 0.2 ? 0.35 : latitude;
      viewer.camera.setView({ destination: Cesium.Cartesian3.fromRadians(longitude, north, 1.8e7) });
      return;
    }
    const sphere = Cesium.BoundingSphere.fromRectangle3D(bounds, Cesium.Ellipsoid.WGS84, middleHeight);
    const { clientWidth, clientHeight } = viewer.canvas;
    const narrow = Math.max(1, clientHeight / clientWidth);
    viewer.camera.flyToBoundingSphere(sphere, {
      duration: 0,
      offset: new Cesium.HeadingPitchRange(0, Cesium.Math.toRadians(-48), sphere.radius * 2.5 * narrow),
    });
  }

  // ---- Colours and light ----------------------------------------------------------------------

  function paint(context, from, to, colours, height) {
    const gradient = context.createLinearGradient(from, 0, to, 0);
    colours.forEach((colour, at) => gradient.addColorStop(at / (colours.length - 1), colour));
    context.fillStyle = gradient;
    context.fillRect(from, 0, to - from, height);
  }

  /** Left half: the sea from its deepest place up to 0 m. Right half: the land. */
  function colourRamp() {
    const canvas = Object.assign(document.createElement("canvas"), { width: 512, height: 1 });
    const context = canvas.getContext("2d");
    paint(context, 0, 256, SEA, 1);
    paint(context, 256, 512, LAND, 1);
    return canvas;
  }

  /**
   * Colour by height within the bounds, grey around them (there the set holds what voids were filled with), and
   * tile borders: texture coordinates run from 0 to 1 over each tile drawn.
   */
  function terrainMaterial([low, high], bounds) {
    return new Cesium.Material({ fabric: {
      uniforms: {
        corner: new Cesium.Cartesian2(bounds.west, bounds.south),
        extent: new Cesium.Cartesian2(bounds.width, bounds.height),
        ramp: colourRamp(), deepest: Math.min(low, -0.1 * (high - low)), lowest: Math.max(low, 0),
        highest: Math.max(high, 1), exaggeration: 1,
        borders: 0,
      },
      source: `
        // Longitude and latitude of the surface (heights move the latitude by far less than a pixel).
        vec2 place_on_globe(vec3 positionToEyeEC) {
          vec3 place = (czm_inverseView * vec4(-positionToEyeEC, 1.0)).xyz;
          return vec2(atan(place.y, place.x), atan(place.z, ${1 - WGS84_E2} * length(place.xy)));
        }

        czm_material czm_getMaterial(czm_materialInput materialInput) {
          czm_material material = czm_getDefaultMaterial(materialInput);
          float height = materialInput.height / exaggeration;
          float half_texel = 0.5 / 512.0;
          float sea = clamp(1.0 - height / deepest, 0.0, 1.0) * 0.5;
          float land = clamp((height - lowest) / (highest - lowest), 0.0, 1.0) * 0.5 + 0.5;
          // Voids filled with 0 m come back a quantization step off: land, all of them.
          float at = height < -5e-4 * (highest - deepest) ? clamp(sea, half_texel, 0.5 - half_texel)
                                  : clamp(land, 0.5 + half_texel, 1.0 - half_texel);
          material.diffuse = texture(ramp, vec2(at, 0.5)).rgb;
          vec2 within = place_on_globe(materialInput.positionToEyeEC) - corner;
          within.x = mod(within.x, czm_twoPi);
          vec2 rounding = vec2(2e-6);
          bool outside = any(greaterThan(within, extent + rounding)) || within.y < -rounding.y;
          if (outside) material.diffuse = mix(vec3(0.46), material.diffuse, 0.12);
          vec2 pixel = fwidth(materialInput.st);
          vec2 rim = min(materialInput.st, 1.0 - materialInput.st) / max(pixel, vec2(1e-6));
          float line = 1.0 - smoothstep(0.5, 1.3, min(rim.x, rim.y));
          material.diffuse = mix(material.diffuse, vec3(0.75, 0.12, 0.05), line * borders);
          material.alpha = 1.0;
          return material;
        }`,
    } });
  }

  function showLegend([low, high]) {
    const canvas = document.querySelector("#legend canvas");
    const context = canvas.getContext("2d");
    const ticks = [low, high];
    const shore = low < 0 && high > 0 ? (-low / (high - low)) * canvas.width : low < 0 ? canvas.width : 0;
    if (shore > 0) paint(context, 0, shore, SEA, canvas.height);
    if (shore < canvas.width) paint(context, shore, canvas.width, LAND, canvas.height);
    if (shore > 0.15 * canvas.width && shore < 0.85 * canvas.width) ticks.splice(1, 0, 0);
    document.getElementById("ticks").replaceChildren(...ticks.map((height) => {
      const tick = document.createElement("span");
      tick.textContent = formatHeight(height, 0);
      if (height === 0 && ticks.length === 3) {
        Object.assign(tick.style, { position: "absolute", left: `${(100 * shore) / canvas.width}%`,
          transform: "translateX(-50%)" });
      }
      return tick;
    }));
    document.getElementById("legend").hidden = false;
  }

  /** The light comes from the upper left of the screen, lower when the camera is near the ground. */
  function lightFromUpperLeft(viewer) {
    const { camera } = viewer;
    const frame = new Cesium.Matrix4();
    const local = new Cesium.Cartesian3();
    const light = new Cesium.DirectionalLight({ direction: new Cesium.Cartesian3(0, 0, -1), intensity: 1 });
    viewer.scene.light = light;
    viewer.scene.preUpdate.addEventListener(() => {
      const far = Cesium.Math.clamp(Math.log10(camera.positionCartographic.height / 2e5), 0, 1.5) / 1.5;
      const altitude = Cesium.Math.toRadians(Cesium.Math.lerp(42, 62, far));
      // From above, heading alone says where the top of the screen is.
      const azimuth = camera.heading - Cesium.Math.toRadians(45);
      local.x = -Math.sin(azimuth) * Math.cos(altitude);
      local.y = -Math.cos(azimuth) * Math.cos(altitude);
      local.z = -Math.sin(altitude);
      Cesium.Transforms.eastNorthUpToFixedFrame(camera.positionWC, Cesium.Ellipsoid.WGS84, frame);
      Cesium.Matrix4.multiplyByPointAsVector(frame, local, light.direction);
    });
  }

  return { boundsOf, formatHeight, heightRange, lightFromUpperLeft, lookAt, showLegend, terrainMaterial };
})();
