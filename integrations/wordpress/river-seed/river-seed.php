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
 * first author who sees the page (poster.js), and kept in the media library; the post knows its number.
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
add_action( 'rest_insert_attachment', 'river_seed_keep', 10, 2 );

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

/** Returns the HTML of a map, named by a word, by a link such as `seed=kauri&land=valley`, or by the address of a map: the element reads it. */
function river_seed_html( $map, $alt ) {
	if ( trim( $map ) === '' ) {
		return river_seed_error( 'a word or a link is wanted, as map="kauri" or map="seed=kauri&land=valley"' );
	}
	if ( preg_match( '/[\x00-\x1f\x7f]/', $map ) ) {
		return river_seed_error( 'the map holds a character that cannot be shown' );
	}
	$html = sprintf(
		'<river-seed %s="%s"%s%s%s style="display:block;aspect-ratio:%s;min-height:0;overflow:hidden">%s</river-seed>',
		strpos( $map, '=' ) === false ? 'seed' : 'recipe',
		river_seed_attr( $map ),
		// So that the element draws what the picture shows after an upgrade too.
		strpos( $map, 'edition=' ) === false ? sprintf( ' edition="%d"', RIVER_SEED_EDITION ) : '',
		$alt === '' ? '' : sprintf( ' alt="%s"', river_seed_attr( $alt ) ),
		river_seed_scripts( $map ),
		river_seed_aspect( $map ),
		river_seed_picture( $map, $alt )
	);
	// Shortcodes run after blocks, in attributes too. This is how WordPress itself writes brackets that begin none.
	return strtr( $html, array( '[' => '&#091;', ']' => '&#093;' ) );
}

/** Returns the aspect of the space for a map: that in its link, within the element's range. */
function river_seed_aspect( $map ) {
	return preg_match( '/\baspect=(\d+(?:\.\d+)?)(?![^&#])/', $map, $found ) ? min( 4, max( 0.25, (float) $found[1] ) ) : 1.6;
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
	$post = get_the_ID();
	if ( ! $post || river_seed_attachment( $map ) || ! current_user_can( 'upload_files' ) || ! current_user_can( 'edit_post', $post ) ) {
		return '';
	}
	wp_enqueue_script_module( 'river-seed-poster' );
	return sprintf(
		' data-poster="%s" data-size="%d" data-media="%s" data-post="%d" data-nonce="%s"',
		esc_attr( river_seed_name( $map ) ),
		RIVER_SEED_SIZE,
		esc_url( rest_url( 'wp/v2/media' ) ),
		$post,
		esc_attr( wp_create_nonce( 'wp_rest' ) )
	);
}

/** Returns the picture, or until there is one the words in its place. A picture's own text alternative names the seed. */
function river_seed_picture( $map, $alt ) {
	$attachment = river_seed_attachment( $map );
	$looks      = array( 'style' => 'display:block;width:100%;height:auto' ) + ( $alt === '' ? array() : array( 'alt' => $alt ) );
	if ( ! $attachment ) {
		return sprintf( '<p style="margin:0">%s</p>', esc_html( $alt === '' ? 'A map of rivers' : $alt ) );
	}
	return wp_get_attachment_image( $attachment, 'large', false, $looks );
}

/** Returns the number of a map's picture in the media library, as this post keeps it; 0 if there is none. */
function river_seed_attachment( $map ) {
	$post       = get_the_ID();
	$attachment = $post ? (int) get_post_meta( $post, '_' . river_seed_name( $map ), true ) : 0;
	return $attachment && wp_attachment_is_image( $attachment ) ? $attachment : 0;
}

/**
 * Keeps the number of a picture that an author's browser has sent, with the post it was sent for. The media library takes it only from those
 * who may edit that post, so nobody chooses the pictures in another's posts.
 */
function river_seed_keep( $attachment, $request ) {
	$name = (string) $request['river_seed'];
	if ( $attachment->post_parent && preg_match( '/^river-seed-[0-9a-f]{16}$/D', $name ) ) {
		update_post_meta( $attachment->post_parent, "_$name", $attachment->ID );
	}
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
