<?php
/**
 * Plugin Name: River Seed
 * Description: Rivers that grow from a word: the shortcode [river-seed] and a block. Everything comes from this site.
 * Version: 0.1.0
 * Requires at least: 6.5
 * Requires PHP: 7.4
 * License: MIT or Apache-2.0
 *
 * The element is written on the server, so no filter of what authors save takes it away. Its picture is drawn by the browser of the
 * first author who sees the page (poster.js), and kept in the media library under a name that is a hash of the map.
 */

defined( 'ABSPATH' ) || exit;

const RIVER_SEED_VERSION = '0.1.0';
const RIVER_SEED_LEAST   = '6.5';
/** The edition of the algorithms that the element in this plugin draws. */
const RIVER_SEED_EDITION = 1;
/** The longer side of a picture in pixels. */
const RIVER_SEED_SIZE    = 1200;

add_action( 'init', 'river_seed_register' );
add_action( 'admin_notices', 'river_seed_tell_version' );

function river_seed_register() {
	add_shortcode( 'river-seed', 'river_seed_shortcode' );
	register_block_type( __DIR__ . '/block', array( 'render_callback' => 'river_seed_block' ) );
	if ( river_seed_has_modules() ) {
		wp_register_script_module( 'river-seed', plugins_url( 'element/river-seed.js', __FILE__ ), array(), RIVER_SEED_VERSION );
		wp_register_script_module( 'river-seed-poster', plugins_url( 'poster.js', __FILE__ ), array( 'river-seed' ), RIVER_SEED_VERSION );
	}
}

/** Returns the HTML of [river-seed map="kauri" alt="…"]. */
function river_seed_shortcode( $given, $content = null ) {
	$given = shortcode_atts( array( 'map' => '', 'alt' => '' ), $given, 'river-seed' );
	if ( has_shortcode( (string) $content, 'river-seed' ) ) {
		return river_seed_error( 'a river-seed stands inside another' );
	}
	// The visual editor saves & as &amp;.
	return river_seed_html( wp_specialchars_decode( $given['map'], ENT_QUOTES ), wp_specialchars_decode( $given['alt'], ENT_QUOTES ) );
}

/** Returns the HTML of the block. */
function river_seed_block( $attributes ) {
	return sprintf( '<div %s>%s</div>', get_block_wrapper_attributes(), river_seed_html( $attributes['map'] ?? '', $attributes['alt'] ?? '' ) );
}

/** Returns the HTML of a map, named by a word or by a link such as `seed=kauri&land=valley`. */
function river_seed_html( $map, $alt ) {
	if ( trim( $map ) === '' ) {
		return river_seed_error( 'a word or a link is wanted, as map="kauri" or map="seed=kauri&land=valley"' );
	}
	if ( preg_match( '/[\x00-\x1f\x7f]/', $map ) ) {
		return river_seed_error( 'the map holds a character that cannot be shown' );
	}
	$is_link = preg_match( '/^\??[a-z][a-z-]*=/', $map );
	parse_str( $is_link ? ltrim( $map, '?' ) : '', $values );
	$seed    = $is_link ? $values['seed'] ?? 'kauri' : $map;
	$picture = river_seed_picture( $map, $alt === '' ? sprintf( 'Rivers grown from “%s”', is_string( $seed ) ? $seed : 'kauri' ) : $alt );
	return sprintf(
		'<river-seed recipe="%s"%s%s style="display:block;aspect-ratio:%s;min-height:0;overflow:hidden">%s</river-seed>',
		river_seed_attr( river_seed_link( $map, $is_link ) ),
		$alt === '' ? '' : sprintf( ' alt="%s"', river_seed_attr( $alt ) ),
		river_seed_scripts( $map ),
		min( 4, max( 0.25, is_numeric( $values['aspect'] ?? null ) ? (float) $values['aspect'] : 1.6 ) ),
		$picture
	);
}

/** Returns a map's link with the edition, so that the element draws what the picture shows after an upgrade too. */
function river_seed_link( $map, $is_link ) {
	$link = $is_link ? $map : 'seed=' . rawurlencode( $map );
	return preg_match( '/(^\??|&)edition=/', $link ) ? $link : $link . '&edition=' . RIVER_SEED_EDITION;
}

/** Escapes a text for an attribute. `esc_attr` by itself takes `&amp;` for one that is escaped already. */
function river_seed_attr( $text ) {
	return esc_attr( str_replace( '&', '&amp;', $text ) );
}

/** Asks for the element's script, and returns the attributes by which an author's browser makes a picture that is missing. */
function river_seed_scripts( $map ) {
	if ( ! river_seed_has_modules() ) {
		return '';
	}
	wp_enqueue_script_module( 'river-seed' );
	if ( river_seed_attachment( $map ) || ! current_user_can( 'upload_files' ) ) {
		return '';
	}
	wp_enqueue_script_module( 'river-seed-poster' );
	return sprintf(
		' data-poster="%s" data-size="%d" data-media="%s" data-nonce="%s"',
		esc_attr( river_seed_name( $map ) ),
		RIVER_SEED_SIZE,
		esc_url( rest_url( 'wp/v2/media' ) ),
		esc_attr( wp_create_nonce( 'wp_rest' ) )
	);
}

/** Returns the picture, or until there is one the words in its place. */
function river_seed_picture( $map, $alt ) {
	$attachment = river_seed_attachment( $map );
	if ( ! $attachment ) {
		return sprintf( '<p style="margin:0">%s</p>', esc_html( $alt ) );
	}
	return wp_get_attachment_image( $attachment, 'large', false, array( 'alt' => $alt, 'style' => 'display:block;width:100%;height:auto' ) );
}

/** Returns the number of a map's picture in the media library; 0 if there is none. */
function river_seed_attachment( $map ) {
	$found = get_posts(
		array(
			'post_type'   => 'attachment',
			'post_status' => 'inherit',
			'name'        => river_seed_name( $map ),
			'numberposts' => 1,
			'fields'      => 'ids',
		)
	);
	return $found ? $found[0] : 0;
}

/** Returns the name of a map's picture. It is a hash, since words may be any text, also `../`, and of all that decides the pixels. */
function river_seed_name( $map ) {
	return 'river-seed-' . substr( hash( 'sha256', sprintf( '%s edition %d, %d', $map, RIVER_SEED_EDITION, RIVER_SEED_SIZE ) ), 0, 16 );
}

/** Returns what is wrong, for those who can mend it; readers see nothing. */
function river_seed_error( $message ) {
	return current_user_can( 'edit_posts' ) ? sprintf( '<p class="river-seed-error">river-seed: %s</p>', esc_html( $message ) ) : '';
}

function river_seed_has_modules() {
	return function_exists( 'wp_register_script_module' );
}

function river_seed_tell_version() {
	if ( river_seed_has_modules() ) {
		return;
	}
	printf(
		'<div class="notice notice-error"><p>%s</p></div>',
		esc_html( sprintf( 'river-seed: WordPress %s or newer is needed; this is %s. Until then maps are pictures.', RIVER_SEED_LEAST, get_bloginfo( 'version' ) ) )
	);
}
